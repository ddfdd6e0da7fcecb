import { type ColumnScale, formatInColumn } from '../../lib/format.ts';
import { norm, type Vector } from '../../lib/vector.ts';
import { Formula } from './formula.tsx';

const axes = ['x', 'y', 'z'] as const;

export interface VectorRow {
  /** Left-hand side. */
  tex: string;
  vector: Vector;
  /** Whether its length says something. */
  withLength?: boolean;
}

interface Props {
  caption: string;
  rows: readonly VectorRow[];
  scale: ColumnScale;
  /** Heading of a last column with lengths; no such column without it. */
  lengthHeading?: string;
}

/** Vectors one below the other, decimal points aligned. */
export function VectorTable({ caption, rows, scale, lengthHeading }: Props) {
  return (
    <table class="vector-table">
      <caption class="visually-hidden">{caption}</caption>
      <thead>
        <tr>
          <td>{scale.unit}</td>
          {axes.map((axis) => (
            <th key={axis} scope="col">
              {axis}
            </th>
          ))}
          {lengthHeading !== undefined && <th scope="col">{lengthHeading}</th>}
        </tr>
      </thead>
      <tbody>
        {rows.map(({ tex, vector, withLength }) => (
          <tr key={tex}>
            <th scope="row">
              <Formula tex={tex} />
            </th>
            {vector.map((value, axis) => (
              <td key={axes[axis]}>{formatInColumn(value, scale)}</td>
            ))}
            {lengthHeading !== undefined && <td>{withLength && formatInColumn(norm(vector), scale)}</td>}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
