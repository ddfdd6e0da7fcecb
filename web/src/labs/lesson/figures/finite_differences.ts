/** m: small against any spring, large against rounding. */
export const h = 1e-5;

/** In the plane: x and y. */
const axes = [0, 1] as const;

/** p, and then for x and y p with that coordinate of a vertex moved by +h and by −h. Each #V×3, m. */
export function pointsAround(p: Float64Array, vertex: number): Float64Array[] {
  const moved = axes.flatMap((axis) =>
    [h, -h].map((by) => {
      const point = p.slice();
      point[3 * vertex + axis] += by;
      return point;
    }),
  );
  return [p, ...moved];
}

/** Central differences along x and y, N, of the energies at those points, J. */
export function centralDifferences(energies: readonly number[]): number[] {
  return axes.map((axis) => (energies[1 + 2 * axis] - energies[2 + 2 * axis]) / (2 * h));
}
