import { springBetween } from '../../../app/spring_between.ts';
import type { Selection } from '../../../app/state.ts';
import { entryFormat } from '../../../lib/entry_format.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatFixed, formatNumber } from '../../../lib/format.ts';
import { type SymbolId, symbol } from '../../../notation/symbols.ts';
import type { Triplets } from '../../../solver/module.ts';
import { entryAt, type Pattern, type Place, patternOf } from '../../../views/sparsity/pattern.ts';
import type { SparsityModel } from '../../../views/sparsity/sparsity_view.tsx';
import type { Marks } from '../../../views/sparsity/types.ts';
import { coordinateAt, type MatrixAxis } from './axes.ts';
import { roomWords } from './room_words.ts';

export interface MatrixMeaning {
  symbol: SymbolId;
  triplets: Triplets;
  rows: MatrixAxis;
  columns: MatrixAxis;
  /** Of its own; else that of the symbol. */
  unit?: string | null;
  /** Where entries of one matrix have several. */
  unitOf?: (place: Place) => string | null;
  /** E: #E×2. */
  E: Int32Array;
  kinds?: { of: (triplet: number, value: number) => number; colours: SparsityModel['kinds'] };
  /** What there is to say of an entry beside its value. */
  remark?: (entry: number, pattern: Pattern, place: Place) => string;
}

/** Dark above zero, brown below. */
const signColours: SparsityModel['kinds'] = [['--sparsity-negative'], ['--symbol-Q']];

/** A matrix as the view shows it, linked with the springs and vertices of the lab. */
export function modelOf(meaning: MatrixMeaning): SparsityModel {
  const { symbol: id, triplets, rows, columns, E, kinds, remark, unitOf } = meaning;
  const unit = meaning.unit === undefined ? symbol(id).unit : meaning.unit;
  const pattern = patternOf(triplets, kinds?.of);
  const format = entryFormat(triplets.value, unit);

  const thingsAt = ({ row, column }: Place): Selection => {
    const [i, j] = [rows.indexAt(row), columns.indexAt(column)];
    if (rows.thing === 'spring') return { spring: i, vertex: j };
    const spring = i === j ? null : springBetween(E, i, j);
    return spring === null ? { spring, vertex: i } : { spring, vertex: null };
  };

  const marksOf = ({ spring, vertex }: Selection): Marks => {
    const positions = (axis: MatrixAxis, thing: MatrixAxis['thing'], index: number | null) => {
      return index === null || axis.thing !== thing ? [] : axis.positionsOf(index);
    };
    return {
      rows: [...positions(rows, 'spring', spring), ...positions(rows, 'vertex', vertex)],
      columns: positions(columns, 'vertex', vertex),
      places: spring === null || rows.thing === 'spring' ? [] : placesOf(spring),
    };
  };

  /** Where a spring stands in a matrix of vertices by vertices: wherever both of its ends meet. */
  const placesOf = (spring: number): Place[] => {
    const ends = [E[2 * spring], E[2 * spring + 1]];
    const across = ends.flatMap(columns.positionsOf);
    return ends
      .flatMap(rows.positionsOf)
      .flatMap((row) => across.map((column) => ({ row, column })))
      .filter((place) => entryAt(pattern, place) >= 0);
  };

  return {
    symbol: id,
    pattern,
    kinds: kinds?.colours ?? signColours,
    write: format.write,
    head: (axis, index) => {
      const along = axis === 'row' ? rows : columns;
      return `${along.indexAt(index)}${coordinateAt(along, index)}`;
    },
    thingsAt,
    marksOf,
    describe: (place) => {
      const words = roomWords().entry;
      const at = entryAt(pattern, place);
      const value = at < 0 ? '0' : exactly(pattern.value[at], unitOf ? unitOf(place) : unit);
      const text = fillTemplate(words.place, {
        row: place.row,
        rowThing: nameOf(rows, place.row),
        column: place.column,
        columnThing: nameOf(columns, place.column),
        value,
      });
      const note = remark?.(at, pattern, place);
      return note ? `${text}${words.joint}${note}` : text;
    },
  };
}

function nameOf(axis: MatrixAxis, position: number): string {
  const words = roomWords().entry;
  const index = axis.indexAt(position);
  if (axis.coordinates) return fillTemplate(words.coordinate, { index, coordinate: coordinateAt(axis, position) });
  return fillTemplate(axis.pins ? words.pin : words[axis.thing], { index });
}

/** With its sign, as "+1" is the point of A. */
function exactly(value: number, unit: string | null): string {
  const number = Number.isInteger(value) && Math.abs(value) < 1e6 ? formatFixed(value, 0) : formatNumber(value, 4);
  return `${value > 0 ? '+' : ''}${number}${unit === null ? '' : `\u202f${unit}`}`;
}
