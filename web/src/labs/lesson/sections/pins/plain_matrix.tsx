import type { ComponentChildren } from 'preact';
import { formatFixed, formatNumber } from '../../../../lib/format.ts';
import './plain_matrix.css';

interface Props {
  caption: ComponentChildren;
  /** Row-major, size × size, of all vertices. */
  values: Float64Array;
  size: number;
  /** The vertices whose rows and columns are shown. */
  vertices: readonly number[];
  /** Those whose rows and columns are struck out. */
  struck?: readonly number[];
}

/** Rows and columns of some vertices of a #V × #V matrix. */
export function PlainMatrix({ caption, values, size, vertices, struck = [] }: Props) {
  const isStruck = (...heads: number[]) => (heads.some((vertex) => struck.includes(vertex)) ? 'struck' : undefined);
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
              <td key={j} class={isStruck(i, j)}>
                {shown(values[i * size + j])}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function shown(value: number): string {
  return Number.isInteger(value) ? formatFixed(value, 0) : formatNumber(value);
}
