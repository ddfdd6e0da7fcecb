/** Of each list of springs asked about: the first spring of every pair of vertices. */
const found = new WeakMap<Int32Array, Map<number, number>>();

/** More vertices than any scene has: a pair of them is one number, exactly. */
const mostVertices = 2 ** 26;
const pairOf = (i: number, j: number) => Math.min(i, j) * mostVertices + Math.max(i, j);

/** The first spring between two vertices, whichever of them it starts at; null where there is none. E: #E×2, which nobody changes. */
export function springBetween(E: Int32Array, i: number, j: number): number | null {
  let springs = found.get(E);
  if (!springs) {
    springs = new Map();
    for (let e = E.length / 2 - 1; e >= 0; e--) springs.set(pairOf(E[2 * e], E[2 * e + 1]), e);
    found.set(E, springs);
  }
  return springs.get(pairOf(i, j)) ?? null;
}
