import { useMemo } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { defaultKinematics, kinematicsLimits } from '../../../app/kinematics.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { state } from '../../../app/state.ts';
import { curveFrom } from '../../../curves/curve_from.ts';
import { fewestPoints } from '../../../curves/sample_curve.ts';
import { samplings } from '../../../curves/sampling.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { ScaledControl } from '../../../views/controls/scaled_control.tsx';
import { outlineOf } from '../outline.ts';
import { en } from './en.ts';
import { spreadOf } from './spread.ts';
import { SpreadCard } from './spread_card.tsx';
import { zh } from './zh.ts';
import './sampling.css';

/** Of the slider: more points than that are one line to the eye. */
const reach = { min: 8, max: 400 };

/** The curve's points placed in three ways, the same number each. */
export function EvenSampling({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh });
  const { curve: choice, sampling, points } = state.value.kinematics;
  const curve = useMemo(() => {
    const made = curveFrom(choice);
    return made.ok ? made.curve : null;
  }, [choice]);
  const outline = useMemo(() => curve && outlineOf(curve, 0.06, 2000), [curve]);
  const spreads = useMemo(() => curve && samplings.map((one) => spreadOf(curve, one, points)), [curve, points]);
  if (!curve || !outline || !spreads) return null; // until what a link describes badly is replaced
  const fewest = fewestPoints(curve);
  return (
    <section class="even-sampling" id="sampling" aria-labelledby="sampling-heading" data-sampling={sampling}>
      <h3 id="sampling-heading">{words.heading}</h3>
      <p>{words.why}</p>
      <ScaledControl
        id="points"
        letter=""
        symbol={null}
        name={words.points}
        unit=""
        value={points}
        limits={kinematicsLimits.points}
        reach={reach}
        whole
        onSet={(next) => actions.setKinematics({ points: next })}
        reset={{
          label: words.reset,
          onReset:
            points === defaultKinematics.points
              ? null
              : () => actions.setKinematics({ points: defaultKinematics.points }),
        }}
      />
      {points < fewest && <p class="sampling-fewest">{fillTemplate(words.fewest, { count: fewest })}</p>}
      <fieldset class="spreads">
        <legend>{words.choose}</legend>
        {samplings.map((one, i) => (
          <SpreadCard
            key={one}
            sampling={one}
            outline={outline}
            spread={spreads[i] as (typeof spreads)[number]}
            chosen={one === sampling}
            onChoose={() => actions.setKinematics({ sampling: one })}
          />
        ))}
      </fieldset>
      <p class="sampling-note">{words.errorMeaning}</p>
    </section>
  );
}
