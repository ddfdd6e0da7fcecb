/** The first spring between two vertices, whichever of them it starts at; null where there is none. E: #E×2. */
export function springBetween(E: Int32Array, i: number, j: number): number | null {
  for (let e = 0; e < E.length / 2; e++) {
    const [from, to] = [E[2 * e], E[2 * e + 1]];
    if ((from === i && to === j) || (from === j && to === i)) return e;
  }
  return null;
}
