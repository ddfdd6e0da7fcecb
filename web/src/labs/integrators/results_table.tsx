import { inLanguage } from '../../app/messages/in_language.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { formatNumber, formatQuantity } from '../../lib/format.ts';
import { en } from './en.ts';
import { energyRate, total } from './energies.ts';
import { zh } from './zh.ts';

/** Where there is nothing to say. */
const none = '–';

/** What every method has come to, in numbers. */
export function ResultsTable({ run, names }: { run: SideBySide; names: readonly string[] }) {
  const words = inLanguage({ en, zh }).table;
  const { value: energies } = run.energies; // as often as a reader can follow
  const states = run.states.peek();
  const { value: milliseconds } = run.milliseconds;
  return (
    <>
      <table class="results">
        <caption>{words.caption}</caption>
        <thead>
          <tr>
            <th scope="col">{words.method}</th>
            <th scope="col">{words.energy}</th>
            <th scope="col">{words.rate}</th>
            <th scope="col">{words.time}</th>
          </tr>
        </thead>
        <tbody>
          {names.map((name, at) => {
            const last = energies[at]?.at(-1);
            const rate = energyRate(energies[at] ?? []);
            const ms = milliseconds[at] ?? null;
            return (
              <tr key={name}>
                <th scope="row">
                  <svg width="28" height="10" aria-hidden="true" class={`curve curve-${at}`}>
                    <path d="M0 5H28" />
                  </svg>
                  {name}
                </th>
                <td>{last ? formatQuantity(total(last), 'J') : none}</td>
                <td>{rate === null ? none : `${rate > 0 ? '+' : ''}${formatNumber(rate)} J/s`}</td>
                <td>{states?.[at]?.failure ? words.failed : ms === null ? none : formatQuantity(ms, 'ms', 2)}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <p class="results-note">{words.rateHint}</p>
    </>
  );
}
