import { computed, signal } from '@preact/signals';
import { isAbout, type SymbolId, symbolIds, type Thing } from '../notation/symbols.ts';
import type { Figure } from './figure.ts';
import type { Selection } from './state.ts';

/** What the reader points at, with a mouse, a finger or the keyboard. Formulas, matrices, code and pictures all light it. */
export interface Highlight {
  /** One symbol, or those that meet in a line of code. */
  symbols: readonly SymbolId[];
  /** Where it was pointed at; null in running text, which is about every figure. */
  figure: Figure | null;
  /** Of the figure: one spring, one vertex, or both for an entry of a matrix. */
  spring: number | null;
  vertex: number | null;
  /** Where in the symbol's matrix. */
  place: MatrixPlace | null;
  /** The line of code in which the symbols meet. */
  line: CodeLine | null;
}

/** The head of a row or of a column, counted from 0 in the matrix itself, or where both meet: an entry. */
export interface MatrixPlace {
  row: number | null;
  column: number | null;
  /** Of an entry, in the symbol's unit. */
  value: number | null;
}

export interface CodeLine {
  /** In wasm/core. */
  file: string;
  /** From 1, as the page counts them. */
  number: number;
}

export const nothing: Highlight = { symbols: [], figure: null, spring: null, vertex: null, place: null, line: null };

export const highlighted = signal<Highlight>(nothing);

/** The symbols to mark: those pointed at, or all that have a row or column for the spring or vertex pointed at. */
export const litSymbols = computed<readonly SymbolId[]>(() => {
  const { symbols, spring, vertex } = highlighted.value;
  if (symbols.length > 0) return symbols;
  return symbolIds.filter(
    (id) => (spring !== null && isAbout(id, 'spring')) || (vertex !== null && isAbout(id, 'vertex')),
  );
});

/** The spring and vertex to mark in a figure: those pointed at, or the selected ones where a symbol is about such. */
export function litThings(figure: Figure): Selection {
  const { figure: pointedIn, spring, vertex } = highlighted.value;
  if (pointedIn !== null && pointedIn !== figure) return { spring: null, vertex: null };
  if (spring !== null || vertex !== null) return { spring, vertex };
  const selection = figure.selection.value;
  return {
    spring: areAllLit('spring') ? selection.spring : null,
    vertex: areAllLit('vertex') ? selection.vertex : null,
  };
}

/** Whether a symbol other than `except` stands for all springs, or all vertices: pictures mark them as a whole. */
export function areAllLit(thing: Thing, except?: SymbolId): boolean {
  const { symbols, spring, vertex } = highlighted.value;
  return spring === null && vertex === null && symbols.some((id) => id !== except && isAbout(id, thing));
}
