import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { state } from '../../../app/state.ts';
import { Choice } from '../../../lib/choice.tsx';
import { ikMethods } from '../../../solver/inverse_kinematics.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';
import './settings.css';

/** How the arm finds its pose. The same target is searched for again from where the arm was. */
export function MethodChoice({ actions }: { actions: Actions }) {
  const { methods } = inLanguage({ en, zh });
  const { method } = state.value.kinematics;
  return (
    <div class="method-choice">
      <Choice
        label={methods.label}
        options={ikMethods.map((name) => [name, methods[name]] as const)}
        chosen={method}
        onChoose={(next) => actions.setKinematics({ method: next })}
      />
    </div>
  );
}
