import { useRef } from 'preact/hooks';
import { type ColumnScale, formatInColumn } from '../../../lib/format.ts';
import { useKeyboardScroll } from '../../../lib/use_keyboard_scroll.ts';
import type { Vector } from '../../../lib/vector.ts';

interface Props {
  label: string;
  rows: readonly Vector[];
  scale: ColumnScale;
  /** How many columns belong together. */
  group?: number;
}

/** A matrix in brackets. A wide one scrolls in its own box. */
export function NumberMatrix({ label, rows, scale, group = Number.POSITIVE_INFINITY }: Props) {
  const host = useRef<HTMLDivElement>(null);
  useKeyboardScroll(host);
  return (
    <div ref={host} class="number-matrix">
      <table>
        <caption class="visually-hidden">{label}</caption>
        <tbody>
          {rows.map((entries, row) => (
            <tr key={row}>
              {entries.map((entry, column) => (
                <td key={column} data-begins={column > 0 && column % group === 0}>
                  {formatInColumn(entry, scale)}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
