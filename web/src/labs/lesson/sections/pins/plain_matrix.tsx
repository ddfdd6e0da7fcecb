import type { ComponentChildren } from 'preact';
import type { Figure } from '../../../../app/figure.ts';
import { springBetween } from '../../../../app/spring_between.ts';
import { formatFixed, formatNumber } from '../../../../lib/format.ts';
import type { SymbolId } from '../../../../notation/symbols.ts';
import './plain_matrix.css';

interface Props {
  figure: Figure;
  /** Whose entries these are, where they are those of one symbol. */
  symbol?: SymbolId;
  caption: ComponentChildren;
  /** Row-major, size × size, of all vertices. */
  values: Float64Array;
  size: number;
  /** The vertices whose rows and columns are shown. */
  vertices: readonly number[];
  /** Those whose rows and columns are struck out. */
  struck?: readonly number[];
}

/** Rows and columns of some vertices of a #V × #V matrix, whose entries belong to vertices and to the springs between them. */
export function PlainMatrix({ figure, symbol, caption, values, size, vertices, struck = [] }: Props) {
  const isStruck = (...heads: number[]) => (heads.some((vertex) => struck.includes(vertex)) ? 'struck' : undefined);
  const entryAttributes = (i: number, j: number) => {
    const value = values[i * size + j];
    const spring = value === 0 || i === j ? null : springBetween(figure.scene.value.E, i, j);
    return {
      'data-vertex': i === j ? i : undefined,
      'data-spring': spring ?? undefined,
      ...(symbol && { 'data-about': symbol, 'data-row': i, 'data-column': j, 'data-value': value }),
    };
  };
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
              <td key={j} class={isStruck(i, j)} {...entryAttributes(i, j)}>
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
