import { useState } from 'preact/hooks';
import type { KinematicsSettings } from '../../../app/kinematics.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatLength } from '../../../lib/format.ts';
import { steps125 } from '../../../lib/steps_125.ts';
import { AngleFigure } from './angle_figure.tsx';
import { CountsTable } from './counts_table.tsx';
import { freeTask } from './free_task.ts';
import { Histograms } from './histograms.tsx';
import { questionCurves, questionTargets } from './question_targets.ts';
import { questionWords } from './question_words.ts';
import { Slider } from './slider.tsx';
import { useAnswer } from './use_answer.ts';
import type { Experiments } from './use_experiments.ts';

/** m. */
const epsilons = steps125(1e-5, 1e-2);
const targetsOfCurve = 200;
const curves = questionCurves.map((curve) => questionTargets(curve, targetsOfCurve));

/** How many iterations every method takes for all targets of the lab's circle and heart, in both precisions. */
export function Iterations({ experiments, settings }: { experiments: Experiments; settings: KinematicsSettings }) {
  const words = questionWords().iterations;
  const [asked, ask] = useState(false);
  const [epsilon, setEpsilon] = useState(1e-4);
  const [iterations, setIterations] = useState(100);

  const { links, root } = settings;
  const answered = useAnswer(experiments, asked ? { links, root, epsilon, iterations } : null, (wish) => {
    const task = freeTask({ ...settings, ...wish });
    return (service) => service.countIterations(task, curves);
  });
  return (
    <div data-answered={answered !== null} data-epsilon={answered?.wish.epsilon}>
      <div class="question-row">
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
        {!asked && (
          <button type="button" onClick={() => ask(true)}>
            {fillTemplate(words.go, { targets: curves.length * targetsOfCurve })}
          </button>
        )}
      </div>
      {answered && <Histograms counts={answered.answer} />}
      {answered && <CountsTable counts={answered.answer} most={answered.wish.iterations} />}
      <AngleFigure epsilon={epsilon} lengths={links.map(({ length }) => length)} />
    </div>
  );
}
