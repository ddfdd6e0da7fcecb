import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { Prose } from '../../views/equations/prose.tsx';
import { lessonWords } from './lesson_words.ts';

interface Props {
  ask: string;
  hint: string;
  answer: string;
  /** An experiment that belongs to the answer; made when the answer is looked at. */
  children?: ComponentChildren;
}

/** A question of the course, to be thought about before it is answered. */
export function Question({ ask, hint, answer, children }: Props) {
  const [answered, setAnswered] = useState(false);
  const words = lessonWords().question;
  return (
    <aside class="question" aria-label={words.label}>
      <p class="question-label" aria-hidden="true">
        {words.label}
      </p>
      <Prose text={ask} />
      <details>
        <summary>{words.hint}</summary>
        <Prose text={hint} />
      </details>
      <details onToggle={(event) => setAnswered(event.currentTarget.open)}>
        <summary>{words.answer}</summary>
        <Prose text={answer} />
        {answered && children}
      </details>
    </aside>
  );
}
