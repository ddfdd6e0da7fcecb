import type { Pattern, Place } from './pattern.ts';
import type { Viewport } from './viewport.ts';

/** What is marked of a matrix. */
export interface Marks {
  rows: readonly number[];
  columns: readonly number[];
  places: readonly Place[];
}

export const noMarks: Marks = { rows: [], columns: [], places: [] };

/** Colours are all "#rrggbb". */
export interface Ink {
  background: string;
  text: string;
  muted: string;
  line: string;
  accent: string;
  /** CSS pixels of the page's text for each of its usual 16. */
  typeScale: number;
  /** For each kind of entry: one colour, or several beside each other in its cell. The first is what is seen from afar. */
  kinds: readonly (readonly string[])[];
}

/** What a picture shows. */
export interface Sparsity {
  pattern: Pattern;
  view: Viewport;
  ink: Ink;
  marks: Marks;
  /** The cell that the keyboard stands in. */
  focus: Place | null;
  /** An entry as written in its cell. */
  write: (value: number) => string;
  /** A row's or column's number as written at the edge. */
  head: (axis: 'row' | 'column', index: number) => string;
}

/** CSS pixels beside the matrix, for the heads. */
export const margin = { left: 44, top: 22, right: 8, bottom: 1 };

export const fontOf = (pixels: number) => `${pixels}px "Source Sans 3 Variable", system-ui, sans-serif`;
