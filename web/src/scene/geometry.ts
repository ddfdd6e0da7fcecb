/** What the file of a scene's vertices says, as far as scenes use it. */
export interface Geometry {
  /** #V by 3, metres, row-major. */
  V: Float64Array;
  /** #E by 2, row-major: springs, indices into the rows of V, in the order and direction in which each first occurs. */
  E: Int32Array;
  /** #F by 3, row-major: triangles of the surface, indices into the rows of V. */
  F: Uint32Array;
  /** #T by 4, row-major: tetrahedra, indices into the rows of V; empty for all that is no solid. */
  T: Uint32Array;
  /** #VT by 2, dimensionless, row-major: texture coordinates. */
  VT: Float32Array;
  /** #F by 3, row-major: indices into the rows of VT, corner by corner with F; null when some corner has none. */
  FT: Uint32Array | null;
}

/** Caps on what is read, so that a wrong file ends in a sentence and not in a full memory. */
export const maxVertices = 100_000;
export const maxSprings = 500_000;
