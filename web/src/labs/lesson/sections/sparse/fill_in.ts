/** Which entries of a symmetric matrix are not zero: neighbours[i] holds every j ≠ i with an entry at (i, j). */
export type Pattern = readonly ReadonlySet<number>[];

/** Where L is not zero, in the rows and columns of P Q Pᵀ. */
export interface FactorPattern {
  /** Below the diagonal, where Q is not zero either. */
  kept: [number, number][];
  /** Below the diagonal, where Q is zero. */
  filled: [number, number][];
}

/** The pattern of Q: two vertices meet in it if a spring joins them. */
export function patternOf(n: number, E: ArrayLike<number>): Pattern {
  const neighbours = Array.from({ length: n }, () => new Set<number>());
  for (let e = 0; e < E.length / 2; e++) {
    neighbours[E[2 * e]].add(E[2 * e + 1]);
    neighbours[E[2 * e + 1]].add(E[2 * e]);
  }
  return neighbours;
}

/** Row by row, as the vertices are numbered. */
export function naturalOrder(pattern: Pattern): number[] {
  return pattern.map((_, vertex) => vertex);
}

/** Always the vertex with the fewest neighbours left; its neighbours then become neighbours of each other. */
export function minimumDegreeOrder(pattern: Pattern): number[] {
  const graph = copy(pattern);
  const left = new Set(naturalOrder(pattern));
  const order: number[] = [];
  while (left.size > 0) {
    const next = [...left].reduce((best, vertex) => (graph[vertex].size < graph[best].size ? vertex : best));
    eliminate(graph, next);
    left.delete(next);
    order.push(next);
  }
  return order;
}

/** The pattern of L when the vertices are eliminated in that order. */
export function factorPattern(pattern: Pattern, order: readonly number[]): FactorPattern {
  const graph = copy(pattern);
  const rank = new Map(order.map((vertex, at) => [vertex, at]));
  const entries: FactorPattern = { kept: [], filled: [] };
  for (const [column, vertex] of order.entries()) {
    for (const neighbour of graph[vertex]) {
      const place: [number, number] = [rank.get(neighbour) as number, column];
      (pattern[vertex].has(neighbour) ? entries.kept : entries.filled).push(place);
    }
    eliminate(graph, vertex);
  }
  return entries;
}

/** Takes a vertex out and joins all its neighbours: what one column of a Cholesky factorisation does to the rest. */
function eliminate(graph: Set<number>[], vertex: number): void {
  for (const a of graph[vertex]) {
    for (const b of graph[vertex]) if (a !== b) graph[a].add(b);
    graph[a].delete(vertex);
  }
}

function copy(pattern: Pattern): Set<number>[] {
  return pattern.map((neighbours) => new Set(neighbours));
}

/** (column, row) for every (row, column): the other half of a symmetric pattern. */
export function transposed(places: readonly (readonly [number, number])[]): [number, number][] {
  return places.map(([row, column]) => [column, row]);
}
