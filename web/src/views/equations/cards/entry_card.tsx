import { type Entry, entryMeaning } from '../../../app/entry_meaning.ts';
import type { Figure } from '../../../app/figure.ts';
import type { Head } from '../../../app/heads.ts';
import { t } from '../../../app/messages/index.ts';
import { written } from '../../../app/symbol_value.ts';
import { symbolCommand } from '../../../notation/macros.ts';
import { symbol } from '../../../notation/symbols.ts';
import { Formula } from '../formula.tsx';
import { Facts } from './facts.tsx';
import { LessonLink } from './lesson_link.tsx';

interface Props {
  entry: Entry;
  figure: Figure;
}

/** An entry of a matrix: what its row and column belong to, its value, and why it has that value. */
export function EntryCard({ entry, figure }: Props) {
  const { symbol: id, row, column, value } = entry;
  const { unit, section } = symbol(id);
  const meaning = entryMeaning(entry, figure);
  return (
    <>
      <p class="card-name">
        <Formula tex={`${symbolCommand(id)}_{${column ? `${row.short},\\,${column.short}` : row.short}}`} /> ={' '}
        <strong>{written([value], unit)}</strong> <span>{t(`symbols.name.${id}`)}</span>
      </p>
      {meaning && <p>{meaning}</p>}
      <Facts
        facts={[
          [t('equations.card.row'), nameOf(row, figure)],
          column && [t('equations.card.columnName'), nameOf(column, figure)],
          [t('equations.card.unit'), unit ?? t('equations.card.dimensionless')],
        ]}
      />
      <LessonLink section={section} />
    </>
  );
}

/** As read out, without the value. */
export function entryName({ symbol: id, row, column }: Entry): string {
  const code = symbol(id).code;
  return column
    ? t('equations.card.entry.name', { code, row: row.name, column: column.name })
    : t('equations.card.entry.nameInVector', { code, row: row.name });
}

/** Of a spring also its ends: an entry is mostly about one of them. */
function nameOf({ thing, index, name }: Head, figure: Figure): string {
  if (thing !== 'spring') return name;
  const { E } = figure.scene.value;
  return `${name}, ${t('equations.card.spring.ends', { i: E[2 * index], j: E[2 * index + 1] })}`;
}
