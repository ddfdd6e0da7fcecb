import { type ColumnScale, formatInColumn } from '../../lib/format.ts';
import { Formula } from './formula.tsx';
import { norm, type Vector } from './vector.ts';

interface Props {
  caption: string;
  /** Left-hand sides in TeX, and what they equal. */
  rows: readonly { tex: string; vector: Vector }[];
  scale: ColumnScale;
  /** Heading of a last column with the vectors' lengths; no such column without it. */
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
          <th scope="col">x</th>
          <th scope="col">y</th>
          <th scope="col">z</th>
          {lengthHeading !== undefined && <th scope="col">{lengthHeading}</th>}
        </tr>
      </thead>
      <tbody>
        {rows.map(({ tex, vector }) => (
          <tr key={tex}>
            <th scope="row">
              <Formula tex={tex} />
            </th>
            {[...vector, ...(lengthHeading === undefined ? [] : [norm(vector)])].map((value, column) => (
              <td key={column}>{formatInColumn(value, scale)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
