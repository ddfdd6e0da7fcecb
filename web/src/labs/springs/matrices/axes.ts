import type { Thing } from '../../../notation/symbols.ts';

/** What the rows or columns of a matrix stand for. */
export interface MatrixAxis {
  thing: Thing;
  count: number;
  /** Whether each is a pin, and so a vertex by another number. */
  pins?: boolean;
  /** Whether each is one coordinate of a vertex, x, y and z by turns. */
  coordinates?: boolean;
  /** The spring or vertex of a row, */
  indexAt(position: number): number;
  /** and its rows; none where it has none. */
  positionsOf(index: number): readonly number[];
}

/** One row for every spring or vertex, in their own order. */
export function numbered(thing: Thing, count: number): MatrixAxis {
  return { thing, count, indexAt: (position) => position, positionsOf: (index) => (index < count ? [index] : []) };
}

/** One row for each of these vertices, in this order. */
export function listed(vertices: Int32Array, pins = false): MatrixAxis {
  const positions = new Map(Array.from(vertices, (vertex, position) => [vertex, [position]]));
  return {
    thing: 'vertex',
    count: vertices.length,
    pins,
    indexAt: (position) => vertices[position],
    positionsOf: (vertex) => positions.get(vertex) ?? [],
  };
}

/** Three rows for each vertex of an axis: coordinate c of its i-th is row 3i + c. */
export function byCoordinates(vertices: MatrixAxis): MatrixAxis {
  return {
    ...vertices,
    count: 3 * vertices.count,
    coordinates: true,
    indexAt: (position) => vertices.indexAt(Math.floor(position / 3)),
    positionsOf: (index) => vertices.positionsOf(index).flatMap((at) => [3 * at, 3 * at + 1, 3 * at + 2]),
  };
}

/** Which coordinate a row is of; empty where rows are of whole springs or vertices. */
export function coordinateAt({ coordinates }: MatrixAxis, position: number): string {
  return coordinates ? 'xyz'[position % 3] : '';
}
