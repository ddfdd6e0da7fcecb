/** A scene: what a simulation starts from. Parsed and validated once; everything after the parser trusts it. */
export interface Scene {
  /** File name without directory and extension, e.g. "flag". */
  name: string;
  /** #V by 3, metres, row-major: rest positions. */
  V: Float64Array;
  /** #E by 2, row-major: springs, zero-based indices into the rows of V. */
  E: Int32Array;
  /** #F by 3, row-major: triangles of the rendered surface (polygons fanned); empty for a pure network of springs. */
  F: Uint32Array;
  /** Texture coordinates of the surface, or null. `FT` indexes rows of `VT`, corner by corner with F. */
  texture: { url: string; VT: Float32Array; FT: Uint32Array } | null;
  /** #V, kg: uniform, or when the file gives none a quarter of each tetrahedron at 1 kg/m³, in what is no solid a third of each triangle at 1 kg/m². */
  m: Float64Array;
  /** Zero-based indices of the pinned vertices, ascending; each is held at its rest position. */
  pinned: Int32Array;
  /** N/m. */
  k: number;
  /** Optional fields of the format that the course's own files lack, with their defaults filled in. */
  delta_t: number; // seconds, 1/30 unless given
  iterations: number; // 50 unless given
  w: number; // N/m, 1e10 unless given
  gravity: number; // m/s² downwards, 9.8 unless given
  damping: number; // N·s/m along every spring, 0 unless given
}

/** What stands in for a scene before there is one. */
export const noScene: Scene = {
  name: '',
  V: new Float64Array(0),
  E: new Int32Array(0),
  F: new Uint32Array(0),
  texture: null,
  m: new Float64Array(0),
  pinned: new Int32Array(0),
  k: 1,
  delta_t: 1 / 30,
  iterations: 50,
  w: 1e10,
  gravity: 9.8,
  damping: 0,
};
