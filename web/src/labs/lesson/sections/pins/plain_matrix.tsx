import type { ComponentChildren } from 'preact';
import { formatNumber } from '../../../../lib/format.ts';

interface Props {
  caption: ComponentChildren;
  /** Row-major, size × size, of all vertices. */
  values: Float64Array;
  size: number;
  /** The vertices whose rows and columns are shown. */
  vertices: readonly number[];
}

/** Rows and columns of some vertices of a #V × #V matrix. */
export function PlainMatrix({ caption, values, size, vertices }: Props) {
  return (
    <table class="numbers plain-matrix">
      <caption>{caption}</caption>
      <thead>
        <tr>
          <td />
          {vertices.map((j) => (
            <th key={j} scope="col" data-vertex={j}>
              {j}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {vertices.map((i) => (
          <tr key={i}>
            <th scope="row" data-vertex={i}>
              {i}
            </th>
            {vertices.map((j) => (
              <td key={j}>{formatNumber(values[i * size + j])}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
