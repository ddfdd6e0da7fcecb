import { inLanguage } from '../../../app/messages/in_language.ts';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { formatNumber } from '../../../lib/format.ts';
import type { VariantState } from '../../../solver/side_by_side.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** Where there is nothing to say. */
const none = '–';

interface Props {
  run: SideBySide;
  names: readonly [string, string];
  /** Whether it may show which of the two makes the mistake. */
  telling: boolean;
}

/** What both solvers have spent. */
export function Costs({ run, names, telling }: Props) {
  const words = inLanguage({ en, zh }).counts;
  run.energies.value; // as often as a reader can follow, instead of with every picture
  const states = run.states.peek();
  const factorising = ({ cost }: VariantState) => (cost ? inMilliseconds(cost.factorising) : none);
  const rows: [string, (state: VariantState) => string][] = [
    [words.time, ({ milliseconds, failure }) => (failure ? none : inMilliseconds(milliseconds))],
    [words.factorisations, ({ factorisations }) => factorisations.toLocaleString('en')],
    [words.stored, ({ cost }) => entriesOfQ(cost, states)],
  ];
  if (telling) rows.splice(2, 0, [words.factorising, factorising]);
  return (
    <table class="costs">
      <caption>{words.caption}</caption>
      <thead>
        <tr>
          <td />
          {names.map((name) => (
            <th key={name} scope="col">
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map(([name, cell]) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            {names.map((net, at) => (
              <td key={net}>{states?.[at] ? cell(states[at]) : ''}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Browsers tell the time to 0.1 ms. */
function inMilliseconds(value: number): string {
  return value < 0.1 ? '< 0.1' : formatNumber(value, 2);
}

/** The right solver stores what is not zero, which is what the mistaken one would have had to. */
function entriesOfQ(cost: VariantState['cost'], states: readonly VariantState[] | null): string {
  const stored = cost ? cost.storedInQ : states?.find((state) => state.cost)?.cost?.nonzerosOfQ;
  return stored === undefined ? '' : stored.toLocaleString('en');
}
