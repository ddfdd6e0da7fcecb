import { formatLength, formatNumber } from '../../../lib/format.ts';
import { questionWords } from './question_words.ts';
import { type Sweeps, sweepNames } from './use_sweeps.ts';

/** All ways to follow the curve, in numbers. */
export function JitterTable({ sweeps }: { sweeps: Sweeps }) {
  const words = questionWords().jitter;
  return (
    <table class="question-table">
      <caption>{words.caption}</caption>
      <thead>
        <tr>
          <th scope="col">{words.way}</th>
          <th scope="col">{words.largest}</th>
          <th scope="col">{words.mean}</th>
          <th scope="col">{words.largestError}</th>
          <th scope="col">{words.missed}</th>
        </tr>
      </thead>
      <tbody>
        {sweepNames.map((name) => {
          const { turns, errors, outcomes } = sweeps[name];
          const between = [...turns.subarray(1)].map((turn) => (turn * 180) / Math.PI);
          return (
            <tr key={name} data-sweep={name}>
              <th scope="row">{words.names[name]}</th>
              <td>{formatNumber(Math.max(...between))}°</td>
              <td>{formatNumber(between.reduce((sum, turn) => sum + turn, 0) / between.length)}°</td>
              <td>{formatLength(Math.max(...errors))}</td>
              <td>{outcomes.filter((outcome) => outcome !== 'CONVERGED').length}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
