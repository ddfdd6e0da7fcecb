import type { Actions } from '../../app/actions.ts';
import {
  type ComparedParameter,
  comparedLimits,
  comparedParameters,
  comparedParametersOn,
} from '../../app/integrators.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { state } from '../../app/state.ts';
import type { SymbolId } from '../../notation/symbols.ts';
import type { Scene } from '../../scene/scene.ts';
import { ScaledControl } from '../../views/controls/scaled_control.tsx';
import { en } from './en.ts';
import { reachOf } from './reach.ts';
import { zh } from './zh.ts';

const letters: Record<ComparedParameter, { letter: string; symbol: SymbolId | null; unit: string }> = {
  k: { letter: 'k', symbol: 'k', unit: 'N/m' },
  mass_scale: { letter: 'm', symbol: 'm', unit: '×' },
  delta_t: { letter: 'Δt', symbol: 'deltaT', unit: 's' },
  damping: { letter: 'c', symbol: null, unit: 'N·s/m' },
  gravity: { letter: 'g', symbol: null, unit: 'm/s²' },
};

/** What all methods have in common, and the hand that pulls. */
export function Settings({ scene, actions }: { scene: Scene; actions: Actions }) {
  const words = inLanguage({ en, zh }).settings;
  const { parameters, poke } = state.value.integrators;
  const inForce = comparedParametersOn(scene, parameters);
  const own = comparedParametersOn(scene, {});
  const back = (name: ComparedParameter) => {
    const { [name]: _, ...others } = parameters;
    actions.setIntegrators({ parameters: others });
  };
  return (
    <section class="controls" aria-labelledby="settings-heading">
      <h3 id="settings-heading">{words.heading}</h3>
      {comparedParameters.map((name) => (
        <ScaledControl
          key={name}
          id={`compared-${name}`}
          {...letters[name]}
          name={words[name]}
          value={inForce[name]}
          limits={comparedLimits[name]}
          reach={reachOf(scene.name, name, own[name])}
          onSet={(value) => actions.setIntegrators({ parameters: { ...parameters, [name]: value } })}
          reset={{ label: words.reset, onReset: parameters[name] === undefined ? null : () => back(name) }}
        />
      ))}
      <h4>{words.pokeHeading}</h4>
      <ScaledControl
        id="poke-stiffness"
        letter=""
        symbol={null}
        unit="N/m"
        name={words.pokeStiffness}
        value={poke.stiffness ?? inForce.k}
        limits={comparedLimits.poke.stiffness}
        reach={reachOf(scene.name, 'k', own.k)}
        onSet={(stiffness) => actions.setIntegrators({ poke: { ...poke, stiffness } })}
        reset={{
          label: words.resetPoke,
          onReset:
            poke.stiffness === null ? null : () => actions.setIntegrators({ poke: { ...poke, stiffness: null } }),
        }}
      />
      <ScaledControl
        id="poke-radius"
        letter=""
        symbol={null}
        unit="×"
        name={words.pokeRadius}
        value={poke.radius}
        limits={comparedLimits.poke.radius}
        onSet={(radius) => actions.setIntegrators({ poke: { ...poke, radius } })}
        reset={{ label: words.resetPoke, onReset: null }}
      />
      <div class="controls-resets">
        <button
          type="button"
          disabled={Object.keys(parameters).length === 0}
          onClick={() => actions.setIntegrators({ parameters: {} })}
        >
          {words.resetAll}
        </button>
      </div>
    </section>
  );
}
