import type { Figure } from '../../../app/figure.ts';
import { headAt } from '../../../app/heads.ts';
import { t } from '../../../app/messages/index.ts';
import { sizeOf } from '../../../app/symbol_value.ts';
import { symbolCommand } from '../../../notation/macros.ts';
import { type Axis, type SymbolId, symbol } from '../../../notation/symbols.ts';
import { Formula } from '../formula.tsx';
import { Facts } from './facts.tsx';
import { LessonLink } from './lesson_link.tsx';

interface Props {
  id: SymbolId;
  /** Counted from 0. */
  column: number;
  figure: Figure;
}

/** A column that belongs to no spring or vertex: one coordinate of all of them, or one end of all springs. */
export function ColumnCard({ id, column, figure }: Props) {
  const { shape, unit, section } = symbol(id);
  const axis = (shape as readonly Axis[])[1];
  const { short } = headAt(axis, column, figure);
  return (
    <>
      <p class="card-name">
        <Formula tex={symbolCommand(id)} /> <strong>{t(`symbols.name.${id}`)}</strong>
      </p>
      <p>{t(axis === '2' ? 'equations.card.endColumn' : 'equations.card.coordinateColumn', { column: short })}</p>
      <Facts
        facts={[
          [t('equations.card.shape'), `${shape.join(' × ')} = ${sizeOf(id, figure)}`],
          [t('equations.card.unit'), unit ?? t('equations.card.dimensionless')],
        ]}
      />
      <LessonLink section={section} />
    </>
  );
}
