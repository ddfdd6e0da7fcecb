import type { Actions } from '../../../app/actions.ts';
import { defaultKinematics, kinematicsLimits } from '../../../app/kinematics.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { state } from '../../../app/state.ts';
import { Choice } from '../../../lib/choice.tsx';
import { NumberField } from '../../../views/controls/number_field.tsx';
import { ScaledControl } from '../../../views/controls/scaled_control.tsx';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** When a search ends, with what numbers it computes, and how far joints may turn. */
export function SearchSettings({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh }).search;
  const { precision, iterations, epsilon, turn } = state.value.kinematics;
  const back = (name: 'iterations' | 'epsilon') =>
    state.value.kinematics[name] === defaultKinematics[name]
      ? null
      : () => actions.setKinematics({ [name]: defaultKinematics[name] });
  return (
    <section class="controls" aria-labelledby="search-heading">
      <h3 id="search-heading">{words.heading}</h3>
      <ScaledControl
        id="search-iterations"
        letter="K"
        symbol={null}
        name={words.iterations}
        unit=""
        value={iterations}
        limits={kinematicsLimits.iterations}
        whole
        onSet={(next) => actions.setKinematics({ iterations: next })}
        reset={{ label: words.reset, onReset: back('iterations') }}
      />
      <ScaledControl
        id="search-epsilon"
        letter="ε"
        symbol="epsilon"
        name={words.epsilon}
        unit="m"
        value={epsilon}
        limits={kinematicsLimits.epsilon}
        onSet={(next) => actions.setKinematics({ epsilon: next })}
        reset={{ label: words.reset, onReset: back('epsilon') }}
      />
      <div class="settings-field">
        <label for="turn-limit">{words.turn}</label>
        <NumberField
          id="turn-limit"
          value={turn}
          {...kinematicsLimits.turn}
          unit="°"
          onSet={(next) => actions.setKinematics({ turn: next })}
          onClear={() => actions.setKinematics({ turn: null })}
        />
      </div>
      <p class="settings-note">{words.turnHint}</p>
      <div class="settings-field">
        <span>{words.precision}</span>
        <Choice
          label={words.precision}
          options={[
            ['double', words.double],
            ['single', words.single],
          ]}
          chosen={precision}
          onChoose={(next) => actions.setKinematics({ precision: next })}
        />
      </div>
      <p class="settings-note">{words.precisionHint}</p>
    </section>
  );
}
