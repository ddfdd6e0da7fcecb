import type { Thing } from '../../../notation/symbols.ts';

/** What the rows or columns of a matrix stand for. */
export interface MatrixAxis {
  thing: Thing;
  count: number;
  /** Whether each is a pin, and so a vertex by another number. */
  pins?: boolean;
  /** The spring or vertex of a row, */
  indexAt(position: number): number;
  /** and its row; −1 where it has none. */
  positionOf(index: number): number;
}

/** One row for every spring or vertex, in their own order. */
export function numbered(thing: Thing, count: number): MatrixAxis {
  return { thing, count, indexAt: (position) => position, positionOf: (index) => (index < count ? index : -1) };
}

/** One row for each of these vertices, in this order. */
export function listed(vertices: Int32Array, pins = false): MatrixAxis {
  const positions = new Map(Array.from(vertices, (vertex, position) => [vertex, position]));
  return {
    thing: 'vertex',
    count: vertices.length,
    pins,
    indexAt: (position) => vertices[position],
    positionOf: (vertex) => positions.get(vertex) ?? -1,
  };
}
