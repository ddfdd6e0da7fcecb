import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { state } from '../../../app/state.ts';
import { ArmSettings } from './arm_settings.tsx';
import { en } from './en.ts';
import { SearchSettings } from './search_settings.tsx';
import { zh } from './zh.ts';
import './settings.css';

/** What can be set besides method and target; folded where the screen has other things to show. */
export function Settings({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh });
  const wide = matchMedia('(min-width: 701px)').matches;
  return (
    <details class="arm-settings" open={wide && !state.value.view.projector}>
      <summary>{words.heading}</summary>
      <div class="arm-settings-body">
        <ArmSettings actions={actions} />
        <SearchSettings actions={actions} />
      </div>
    </details>
  );
}
