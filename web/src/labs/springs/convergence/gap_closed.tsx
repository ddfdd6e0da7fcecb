import type { Actions } from '../../../app/actions.ts';
import { comparison, missingMethod, timeStep } from '../../../app/comparison.ts';
import { frame, parameters, playing } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import type { Frame } from '../../../solver/frame.ts';
import { stopOf } from '../../../solver/stop_of.ts';
import { Phrase, Prose } from '../../../views/equations/prose.tsx';
import { comparisonCurves, gapLeft } from '../../../views/plots/comparison_curves.ts';
import type { en } from './en.ts';

type Words = typeof en.closed;

/** Both scenes move fast then; the flag has hardly begun to turn. */
const tellingStep = 10;

/** N/m: hundred times the flag's own. */
const stiff = 1e5;

/** What share of the gap local/global closes in this time step, next to κ, and scenes to see the difference. */
export function GapClosed({ words, actions }: { words: Words; actions: Actions }) {
  const { stiffnessNumber } = frame.value as Frame;
  return (
    <>
      <p class="gap-closed" role="status" data-complete={isComplete()}>
        <Phrase text={sentence(words, stiffnessNumber)} />
      </p>
      <div class="gap-closed-scenes">
        <button type="button" onClick={() => actions.openStep('net', {}, tellingStep)}>
          {words.net}
        </button>
        <button
          type="button"
          title={words.flagHint}
          onClick={() => actions.openStep('flag', { k: stiff }, tellingStep)}
        >
          {words.flag}
        </button>
      </div>
    </>
  );
}

/** Why κ decides, with its value. */
export function WhyKappa({ words }: { words: Words['why'] }) {
  const { stiffnessNumber } = frame.value as Frame;
  return (
    <details class="why-kappa" open>
      <summary>
        <Phrase text={words.ask} />
      </summary>
      <Prose text={fillTemplate(words.answer, { oneIn: formatNumber(1 + stiffnessNumber, 2) })} />
    </details>
  );
}

/** Whether every method has been heard. */
function isComplete(): boolean {
  return comparison.value?.of === timeStep.value && missingMethod.value === null;
}

function sentence(words: Words, kappa: number): string {
  const { step } = timeStep.value;
  if (playing.value) return words.playing;
  const made = comparison.value;
  const run = made?.runs.find(({ method }) => method === 'local-global');
  if (!made || !run || !isComplete()) return fillTemplate(words.computing, { step });
  const { curves } = comparisonCurves(made.runs, made.rounding);
  const curve = curves[made.runs.indexOf(run)];
  const stop = stopOf(run, parameters.value);
  if (curve.points[0].gap === null) return fillTemplate(words.nothing, { step });
  const left = stop && gapLeft(curve, stop.iterations);
  if (!stop || left === null)
    return fillTemplate(words.givenUp, { made: curve.points.length - 1, kappa: formatNumber(kappa, 2) });
  return fillTemplate(words.sentence, {
    step,
    iterations: stop.iterations,
    share: shareText(words, left),
    kappa: formatNumber(kappa, 2),
  });
}

function shareText(words: Words, left: number): string {
  if (left === 0) return words.all;
  if (left < 1e-3) return fillTemplate(words.nearlyAll, { left: formatNumber(left, 1) });
  const percent = 100 * (1 - left);
  return fillTemplate(words.percent, { percent: Number(percent.toPrecision(percent < 10 ? 2 : 3)) });
}
