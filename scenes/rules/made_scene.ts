import type { Picture } from './picture.ts';

/** A scene as a rule makes it, counted from 0, before it is written down. */
export interface MadeScene {
  /** Base name of its files. */
  name: string;
  /** m: rest positions. */
  vertices: Point[];
  /** A network of springs, perhaps with a plain surface between them, or a surface whose edges are the springs. */
  shape: { springs: Spring[]; triangles?: Triangle[] } | Surface;
  pinned: number[];
  /** N/m. */
  k: number;
  /** kg, of each vertex; a surface may leave its masses to its area. */
  m?: number;
  /** Of each time step, where the default would be too slow to watch. */
  iterations?: number;
  /** s, m/s² and N·s/m, where the default is not meant. */
  delta_t?: number;
  gravity?: number;
  damping?: number;
}

export type Point = [x: number, y: number, z: number];
export type Spring = [i: number, j: number];
export type Triangle = [number, number, number];

export interface Surface {
  triangles: Triangle[];
  textureVertices: [u: number, v: number][];
  /** Indices of texture vertices, corner by corner with `triangles`. */
  textureTriangles: Triangle[];
  picture: Picture;
}
