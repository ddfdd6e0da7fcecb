import type { SmallMatrix } from '../solving/small_matrix.ts';

interface Net {
  /** #E×2. */
  E: Int32Array;
  /** #E, m. */
  r: Float64Array;
  /** #V, kg. */
  m: Float64Array;
  pinned: ArrayLike<number>;
}

/**
 * ∂²E/∂p² at p (#V×3, m), 3#V × 3#V, N/m: what Newton's method solves with. Vertex i has the rows 3i, 3i+1, 3i+2 for x, y, z. A spring adds
 * k [x xᵀ/l² + (1 − r/l)(I − x xᵀ/l²)] at both its ends and subtracts it between them; masses and pins add to the diagonal as in Q.
 */
export function newtonMatrix(
  { E, r, m, pinned }: Net,
  p: Float64Array,
  { k, delta_t, w }: { k: number; delta_t: number; w: number },
): SmallMatrix {
  const H = Array.from(p, () => new Array<number>(p.length).fill(0));
  m.forEach((mass, i) => {
    for (let axis = 0; axis < 3; axis++) H[3 * i + axis][3 * i + axis] += mass / delta_t ** 2;
  });
  for (let row = 0; row < pinned.length; row++) {
    for (let axis = 0; axis < 3; axis++) H[3 * pinned[row] + axis][3 * pinned[row] + axis] += w;
  }
  r.forEach((r_ij, e) => {
    const ends = [E[2 * e], E[2 * e + 1]];
    const x = [0, 1, 2].map((axis) => p[3 * ends[0] + axis] - p[3 * ends[1] + axis]);
    const l = Math.hypot(...x);
    for (let a = 0; a < 3; a++) {
      for (let b = 0; b < 3; b++) {
        const along = (x[a] * x[b]) / l ** 2;
        const H_e = k * (along + (1 - r_ij / l) * ((a === b ? 1 : 0) - along));
        for (const i of ends) {
          for (const j of ends) H[3 * i + a][3 * j + b] += i === j ? H_e : -H_e;
        }
      }
    }
  });
  return H;
}
