/** The vertices that each vertex is joined to. */
export class Neighbours {
  /** #V+1: where in `others` those of a vertex begin. */
  private readonly begin: Uint32Array;
  private readonly others: Uint32Array;

  /** `edges`: #×2. */
  constructor(edges: ArrayLike<number>, vertexCount: number) {
    this.begin = new Uint32Array(vertexCount + 1);
    for (let at = 0; at < edges.length; at++) this.begin[edges[at] + 1] += 1;
    for (let v = 0; v < vertexCount; v++) this.begin[v + 1] += this.begin[v];
    this.others = new Uint32Array(edges.length);
    const next = this.begin.slice();
    for (let at = 0; at < edges.length; at++) this.others[next[edges[at]]++] = edges[at ^ 1];
  }

  of(vertex: number): Uint32Array {
    return this.others.subarray(this.begin[vertex], this.begin[vertex + 1]);
  }
}

/** #F·3×2: the edges of triangles (#F×3), those between two triangles twice. */
export function trianglesEdges(F: Uint32Array): Uint32Array {
  const edges = new Uint32Array(2 * F.length);
  for (let at = 0; at < F.length; at++) {
    edges[2 * at] = F[at];
    edges[2 * at + 1] = F[at % 3 === 2 ? at - 2 : at + 1];
  }
  return edges;
}
