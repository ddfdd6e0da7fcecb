import { highlighted, litThings } from '../../../app/highlight.ts';
import { t } from '../../../app/messages/index.ts';
import { sizeOf, symbolValue } from '../../../app/symbol_value.ts';
import { symbolCommand } from '../../../notation/macros.ts';
import { type SymbolId, symbol, thingAlong } from '../../../notation/symbols.ts';
import { Formula } from '../formula.tsx';
import { type Fact, Facts } from './facts.tsx';
import { LessonLink } from './lesson_link.tsx';

/** What a symbol is: name, meaning, shape, unit, present value, and where the lesson introduces it. */
export function SymbolCard({ id }: { id: SymbolId }) {
  const { unit, code, section, definition } = symbol(id);
  return (
    <>
      <p class="card-name">
        <Formula tex={symbolCommand(id)} /> <strong>{t(`symbols.name.${id}`)}</strong>
      </p>
      <p>{t(`symbols.meaning.${id}`)}</p>
      {definition && (
        <p class="card-definition">
          <Formula tex={definition} />
        </p>
      )}
      <Facts
        facts={[
          [t('equations.card.shape'), shapeText(id)],
          [t('equations.card.unit'), unit ?? t('equations.card.dimensionless')],
          [t('equations.card.code'), <code key="code">{code}</code>],
          presentValue(id),
        ]}
      />
      <LessonLink section={section} />
    </>
  );
}

function shapeText(id: SymbolId): string {
  const { figure } = highlighted.value;
  const { shape } = symbol(id);
  if (shape.length === 0) return t('equations.card.number');
  const counted = shape.join(' × ');
  const size = figure && sizeOf(id, figure);
  return size === null || size === counted ? counted : `${counted} = ${size}`;
}

function presentValue(id: SymbolId): Fact | null {
  const { figure } = highlighted.value;
  if (!figure) return null;
  const at = litThings(figure);
  const value = symbolValue(id, figure, at);
  if (value === null) return null;
  const [rows] = symbol(id).shape;
  const thing = rows && thingAlong(rows);
  const name =
    thing === 'spring'
      ? t('equations.local.spring', { index: at.spring })
      : thing === 'vertex'
        ? t('equations.global.vertex', { index: at.vertex })
        : t('equations.card.value');
  return [name, value];
}
