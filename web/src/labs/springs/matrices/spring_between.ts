/** Finds the spring between two vertices, in either direction; −1 where there is none. E: #E×2. */
export function springFinder(E: Int32Array, vertexCount: number): (i: number, j: number) => number {
  const key = (i: number, j: number) => Math.min(i, j) * vertexCount + Math.max(i, j);
  const springs = new Map<number, number>();
  for (let e = 0; e < E.length / 2; e++) springs.set(key(E[2 * e], E[2 * e + 1]), e);
  return (i, j) => springs.get(key(i, j)) ?? -1;
}
