import { type Axis, type SymbolId, symbol, type Thing, thingAlong } from '../notation/symbols.ts';
import { countAlong, type Figure } from './figure.ts';
import { t } from './messages/index.ts';
import type { Selection } from './state.ts';

/** What stands at the head of a row or column. */
export interface Head {
  /** What the row or column belongs to, and its number in the figure; null for coordinates and ends. */
  thing: Thing | null;
  index: number;
  /** As written beside the numbers; empty over the one column of a vector. */
  short: string;
  /** As read out. */
  name: string;
}

const letters: Partial<Record<Axis, string>> = { '2': 'ij', '3': 'xyz' };

export function headsOf(id: SymbolId, figure: Figure): { rows: Head[]; columns: Head[] } {
  const [rows, columns] = symbol(id).shape;
  const one = [{ thing: null, index: 0, short: '', name: '' }];
  return { rows: rows ? headsAlong(rows, figure) : one, columns: columns ? headsAlong(columns, figure) : one };
}

function headsAlong(axis: Axis, figure: Figure): Head[] {
  return Array.from({ length: countAlong(axis, figure) }, (_, at) => headAt(axis, at, figure));
}

/** Of one row or column along an axis, counted from 0. */
export function headAt(axis: Axis, at: number, figure: Figure): Head {
  const thing = thingAlong(axis);
  if (axis === '3#V' || axis === '3#free') return coordinateHead(axis, at, figure);
  const pinned = axis === '#pinned' ? figure.frame.value?.pinned : undefined;
  const index = pinned ? pinned[at] : at;
  const short = letters[axis]?.[at] ?? String(index);
  return { thing, index, short, name: thing ? t(`matrices.${thing}`, { index }) : short };
}

/** Three rows for each vertex, of all or of those that are free. */
function coordinateHead(axis: '3#V' | '3#free', at: number, figure: Figure): Head {
  const pinned = axis === '3#free' ? (figure.frame.value?.pinned.slice().sort() ?? []) : [];
  let index = Math.floor(at / 3);
  for (const pin of pinned) if (pin <= index) index++;
  const coordinate = 'xyz'[at % 3];
  return {
    thing: 'vertex',
    index,
    short: `${index}${coordinate}`,
    name: t('matrices.coordinate', { index, coordinate }),
  };
}

export function thingsOf({ thing, index }: Head): Selection {
  return { spring: thing === 'spring' ? index : null, vertex: thing === 'vertex' ? index : null };
}

export function isLit({ spring, vertex }: Selection, lit: Selection): boolean {
  return (spring !== null && spring === lit.spring) || (vertex !== null && vertex === lit.vertex);
}
