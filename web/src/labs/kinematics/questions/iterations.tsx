import { useState } from 'preact/hooks';
import type { KinematicsSettings } from '../../../app/kinematics.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatLength } from '../../../lib/format.ts';
import { steps125 } from '../../../lib/steps_125.ts';
import { AngleFigure } from './angle_figure.tsx';
import { CountsTable } from './counts_table.tsx';
import { CurveChoice } from './curve_choice.tsx';
import { freeTask } from './free_task.ts';
import { Histograms } from './histograms.tsx';
import { questionTargets } from './question_targets.ts';
import { questionWords } from './question_words.ts';
import { Slider } from './slider.tsx';
import { useAnswer } from './use_answer.ts';
import type { Experiments } from './use_experiments.ts';

interface Props {
  experiments: Experiments;
  settings: KinematicsSettings;
  /** #T×3, m; null while the arm draws nothing. */
  drawn: Float64Array | null;
}

/** m. */
const epsilons = steps125(1e-5, 1e-2);
const circleAndHeart = [questionTargets('circle', 200), questionTargets('heart', 200)];

/** How many iterations every method takes for all targets of a curve, in both precisions. */
export function Iterations({ experiments, settings, drawn }: Props) {
  const words = questionWords().iterations;
  const [runs, setRuns] = useState(0);
  const [epsilon, setEpsilon] = useState(1e-4);
  const [iterations, setIterations] = useState(100);
  const [wanted, setWanted] = useState<'both' | 'drawn'>('both');

  const { links, root } = settings;
  const curves = drawn && wanted === 'drawn' ? [drawn] : circleAndHeart;
  const wish = { arm: { links, root }, epsilon, iterations, curves, runs };
  const answered = useAnswer(experiments, runs > 0 ? wish : null, (asked) => {
    const task = freeTask({ ...settings, ...asked.arm, epsilon: asked.epsilon, iterations: asked.iterations });
    return (service) => service.countIterations(task, asked.curves);
  });
  const targets = curves.reduce((sum, curve) => sum + curve.length / 3, 0);
  return (
    <div data-answered={answered !== null} data-epsilon={answered?.wish.epsilon}>
      <div class="question-row">
        {drawn && <CurveChoice curves={['both', 'drawn']} chosen={wanted} onChoose={setWanted} />}
        <Slider
          label={words.epsilon}
          {...{ value: epsilons.indexOf(epsilon), min: 0, max: epsilons.length - 1, step: 1 }}
          text={formatLength(epsilon, 1)}
          onSet={(at) => setEpsilon(epsilons[at])}
        />
        <Slider
          label={words.most}
          {...{ value: iterations, min: 5, max: 200, step: 5 }}
          text={String(iterations)}
          onSet={setIterations}
        />
        <button type="button" onClick={() => setRuns(runs + 1)}>
          {fillTemplate(words.go, { targets })}
        </button>
      </div>
      {answered && <Histograms counts={answered.answer} />}
      {answered && <CountsTable counts={answered.answer} most={answered.wish.iterations} />}
      <AngleFigure epsilon={epsilon} lengths={links.map(({ length }) => length)} />
    </div>
  );
}
