import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { Prose } from './prose.tsx';

interface Props {
  ask: string;
  hint: string;
  answer: string;
  /** An experiment that belongs to the answer; made when the answer is looked at. */
  children?: ComponentChildren;
}

/** A question of students, to be thought about before it is answered. */
export function Question({ ask, hint, answer, children }: Props) {
  const [answered, setAnswered] = useState(false);
  return (
    <aside class="question" aria-label={t('equations.question.label')}>
      <p class="question-label" aria-hidden="true">
        {t('equations.question.label')}
      </p>
      <Prose text={ask} />
      <details>
        <summary>{t('equations.question.hint')}</summary>
        <Prose text={hint} />
      </details>
      <details onToggle={(event) => setAnswered(event.currentTarget.open)}>
        <summary>{t('equations.question.answer')}</summary>
        <Prose text={answer} />
        {answered && children}
      </details>
    </aside>
  );
}
