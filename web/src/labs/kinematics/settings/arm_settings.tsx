import type { Actions } from '../../../app/actions.ts';
import { defaultKinematics, kinematicsLimits } from '../../../app/kinematics.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { state } from '../../../app/state.ts';
import { NumberField } from '../../../views/controls/number_field.tsx';
import { en } from './en.ts';
import { LinkList } from './link_list.tsx';
import { presetNames, presets } from './presets.ts';
import { zh } from './zh.ts';

/** What the arm is made of, and where it hangs. */
export function ArmSettings({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh }).arm;
  const { root } = state.value.kinematics;
  return (
    <section aria-labelledby="arm-heading">
      <h3 id="arm-heading">{words.heading}</h3>
      <div class="settings-presets">
        {presetNames.map((name) => (
          <button
            key={name}
            type="button"
            title={words.presetHints[name]}
            onClick={() => actions.setKinematics({ links: presets[name], root: defaultKinematics.root })}
          >
            {words.presets[name]}
          </button>
        ))}
      </div>
      <LinkList actions={actions} />
      <div class="settings-field">
        <label for="root-height">{words.rootHeight}</label>
        <NumberField
          id="root-height"
          value={root[1]}
          {...kinematicsLimits.coordinate}
          unit="m"
          onSet={(height) => actions.setKinematics({ root: [root[0], height, root[2]] })}
        />
      </div>
    </section>
  );
}
