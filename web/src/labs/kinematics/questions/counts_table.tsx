import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatLength, formatQuantity } from '../../../lib/format.ts';
import type { IterationCounts } from '../../../solver/ik_counts.ts';
import { ikOutcomes } from '../../../solver/inverse_kinematics.ts';
import { countOutcomes, median } from './histogram.ts';
import { questionWords } from './question_words.ts';

/** What every method took in both precisions, in numbers; `most`: K. */
export function CountsTable({ counts, most }: { counts: readonly IterationCounts[]; most: number }) {
  const { iterations: words, methods } = questionWords();
  const unreachable = counts.some(({ outcomes }) => outcomes.includes('UNREACHABLE'));
  const ended = ikOutcomes.filter((outcome) => outcome !== 'UNREACHABLE' || unreachable);
  return (
    <>
      <table class="question-table">
        <caption>{fillTemplate(words.caption, { targets: counts[0].outcomes.length, most })}</caption>
        <thead>
          <tr>
            <th scope="col">{words.method}</th>
            <th scope="col">{words.median}</th>
            <th scope="col">{words.largest}</th>
            {ended.map((outcome) => (
              <th key={outcome} scope="col">
                {words.ended[outcome]}
              </th>
            ))}
            <th scope="col">{words.error}</th>
            <th scope="col">{words.time}</th>
          </tr>
        </thead>
        <tbody>
          {counts.map(({ method, precision, iterations, outcomes, largestError, time }) => {
            const ends = countOutcomes(outcomes);
            return (
              <tr key={method + precision} data-method={method} data-precision={precision}>
                <th scope="row">
                  {fillTemplate(words.name, { method: methods[method], precision: words[precision] })}
                </th>
                <td>{median(iterations)}</td>
                <td>{Math.max(...iterations)}</td>
                {ended.map((outcome) => (
                  <td key={outcome}>{ends[outcome]}</td>
                ))}
                <td>{formatLength(largestError)}</td>
                <td>{formatQuantity(1000 * time, 'µs', 2)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <p class="question-note">{words.work}</p>
    </>
  );
}
