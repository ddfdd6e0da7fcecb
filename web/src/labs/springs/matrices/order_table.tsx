import { useId } from 'preact/hooks';
import { eliminations } from '../../../app/matrices.ts';
import { formatNumber } from '../../../lib/format.ts';
import { formatBytes } from '../../../lib/format_bytes.ts';
import { formatTime } from '../../../lib/format_time.ts';
import { grouped } from '../../../lib/grouped.ts';
import type { Elimination } from '../../../solver/matrices.ts';
import { type Ordering, orderings } from '../../../solver/module.ts';
import { roomWords } from './room_words.ts';

/** Of an entry of L: a double and the number of its row. */
const bytesPerEntry = 12;

/** What L costs in each order, one of which is looked at. */
export function OrderTable({ chosen, onChoose }: { chosen: Ordering; onChoose: (ordering: Ordering) => void }) {
  const words = roomWords().elimination;
  const group = useId();
  return (
    <table class="numbers orders">
      <caption>{words.table.caption}</caption>
      <thead>
        <tr>
          <th scope="col">{words.table.order}</th>
          <th scope="col">{words.table.fill}</th>
          <th scope="col">{words.table.flops}</th>
          <th scope="col">{words.table.time}</th>
          <th scope="col">{words.table.bytes}</th>
        </tr>
      </thead>
      <tbody>
        {orderings.map((ordering) => (
          <tr key={ordering} data-ordering={ordering} data-chosen={ordering === chosen}>
            <th scope="row">
              <label title={words.orderNotes[ordering]}>
                <input type="radio" name={group} checked={ordering === chosen} onChange={() => onChoose(ordering)} />
                {words.orders[ordering]}
              </label>
            </th>
            <Costs elimination={eliminations.value[ordering]} />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Costs({ elimination }: { elimination: Elimination | undefined }) {
  if (!elimination)
    return (
      <>
        {[0, 1, 2, 3].map((column) => (
          <td key={column}>…</td>
        ))}
      </>
    );
  const { fill, flops, factor, nonzeros } = elimination;
  return (
    <>
      <td>{grouped(fill)}</td>
      <td>{flops < 1e6 ? grouped(flops) : formatNumber(flops)}</td>
      <td>{factor ? formatTime(factor.milliseconds, 2) : roomWords().elimination.table.untimed}</td>
      <td>{formatBytes(nonzeros * bytesPerEntry)}</td>
    </>
  );
}
