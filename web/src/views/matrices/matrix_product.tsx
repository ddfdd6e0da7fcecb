import type { Figure } from '../../app/figure.ts';
import { type Head, headsOf, isLit, thingsOf } from '../../app/heads.ts';
import { litThings } from '../../app/highlight.ts';
import { t } from '../../app/messages/index.ts';
import { entryFormat } from '../../lib/entry_format.ts';
import { type SymbolId, symbol } from '../../notation/symbols.ts';
import { type Matrix, MatrixTable } from './matrix_table.tsx';

interface Props {
  figure: Figure;
  left: Matrix;
  right: Matrix;
  /** left · right. */
  result: Matrix;
}

/** A product in numbers. The row pointed at is written out as the sum of the rows that it takes from the right factor. */
export function MatrixProduct({ figure, left, right, result }: Props) {
  const { rows, columns } = headsOf(left.symbol, figure);
  const lit = litThings(figure);
  const i = rows.findIndex((row) => isLit(thingsOf(row), lit));
  const taken = columns.flatMap((head, j) => {
    const coefficient = i < 0 ? 0 : left.values[i * columns.length + j];
    return coefficient === 0 ? [] : [{ j, head, coefficient }];
  });
  const { write } = entryFormat(left.values, null);

  return (
    <div class="matrix-product">
      <div class="matrix-factors">
        <MatrixTable figure={figure} {...left} />
        <MatrixTable figure={figure} {...right} marked={taken.map(({ j }) => j)} />
        <span class="matrix-equals">=</span>
        <MatrixTable figure={figure} {...result} />
      </div>
      <p class="matrix-sum" aria-live="polite">
        {i < 0 ? (
          t('matrices.product')
        ) : (
          <>
            <Row of={result.symbol} head={rows[i]} /> = {taken.length === 0 && '0'}
            {taken.map(({ j, head, coefficient }, at) => (
              <span key={j}>
                {at === 0 ? coefficient < 0 && '−' : coefficient < 0 ? ' − ' : ' + '}
                {Math.abs(coefficient) !== 1 && `${write(Math.abs(coefficient))} `}
                <Row of={right.symbol} head={head} />
              </span>
            ))}
          </>
        )}
      </p>
    </div>
  );
}

function Row({ of, head }: { of: SymbolId; head: Head }) {
  return (
    <>
      <b data-sym={of}>{symbol(of).code}</b>
      <sub>{head.short}</sub>
    </>
  );
}
