import type { KinematicsSession, Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { SymbolButton } from '../../../views/equations/symbol_button.tsx';
import { en } from './en.ts';
import { formatError } from './format_error.ts';
import { outcomeText } from './outcome_text.ts';
import { zh } from './zh.ts';
import './result.css';

/** What came of the search: in words, and by how much. */
export function Result({ session }: { session: KinematicsSession }) {
  const words = inLanguage({ en, zh }).result;
  const search = session.search.value as Search; // the lab is shown once there is one
  const { task, answer } = search;
  const enough = answer.error <= task.epsilon;
  return (
    <section class="arm-result" aria-label={words.heading} data-outcome={answer.outcome}>
      <p class={answer.outcome === 'CONVERGED' ? 'arm-outcome' : 'arm-outcome arm-outcome-short'}>
        {outcomeText(search)}
      </p>
      <p class="equation-facts">
        <span>
          {words.error} {formatError(answer.error)} {enough ? '≤' : '>'} <SymbolButton id="epsilon" /> ={' '}
          {formatError(task.epsilon)}
        </span>
        <span>{fillTemplate(words.iterations, { made: answer.iterations, most: task.iterations })}</span>
      </p>
    </section>
  );
}
