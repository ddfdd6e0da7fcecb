import { useComputed } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useMemo } from 'preact/hooks';
import { defaultKinematics, type KinematicsSettings } from '../../../app/kinematics.ts';
import { state } from '../../../app/state.ts';
import { Prose } from '../../../views/equations/prose.tsx';
import { Question } from '../../../views/equations/question.tsx';
import { Iterations } from './iterations.tsx';
import { Jitter } from './jitter.tsx';
import { questionWords } from './question_words.ts';
import { Unreachable } from './unreachable.tsx';
import { useExperiments } from './use_experiments.ts';
import './questions.css';

/** What students ask when an arm does not do as they wish: an experiment for each question, and the answer when it is asked for. `drawn`: #T×3, m, the targets of the curve that the arm draws. */
export function Questions({ drawn }: { drawn: Float64Array | null }) {
  const words = questionWords();
  const experiments = useExperiments();
  // As text, so that a target that is dragged does not draw the charts anew.
  const arm = useComputed(() => JSON.stringify(armOf(state.value.kinematics))).value;
  const settings = useMemo(() => ({ ...defaultKinematics, ...(JSON.parse(arm) as Arm) }), [arm]);
  return (
    <section id="questions" class="questions" aria-labelledby="questions-heading">
      <h3 id="questions-heading">{words.heading}</h3>
      <p>{words.intro}</p>
      <Asked id="unreachable" words={words.unreachable}>
        <Unreachable experiments={experiments} settings={settings} />
      </Asked>
      <Asked id="iterations" words={words.iterations}>
        <Iterations experiments={experiments} settings={settings} drawn={drawn} />
      </Asked>
      <Asked id="jitter" words={words.jitter}>
        <Jitter experiments={experiments} settings={settings} drawn={drawn} />
      </Asked>
    </section>
  );
}

type Arm = Pick<KinematicsSettings, 'links' | 'root' | 'method' | 'precision' | 'iterations' | 'epsilon'>;

/** Of the lab's settings those that the questions are asked with. */
function armOf({ links, root, method, precision, iterations, epsilon }: KinematicsSettings): Arm {
  return { links, root, method, precision, iterations, epsilon };
}

interface AskedProps {
  id: string;
  words: { question: string; tryThis: string; ask: string; hint: string; answer: string };
  children: ComponentChildren;
}

/** The question, what to try, the experiment, and then what to make of it. */
function Asked({ id, words, children }: AskedProps) {
  return (
    <section id={`question-${id}`} aria-labelledby={`question-${id}-heading`}>
      <h4 id={`question-${id}-heading`}>{words.question}</h4>
      <Prose text={words.tryThis} />
      {children}
      <Question ask={words.ask} hint={words.hint} answer={words.answer} />
    </section>
  );
}
