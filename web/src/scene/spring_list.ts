/** Springs in the order and direction in which each first occurs; one that occurs again, in either direction, is the same spring. */
export class SpringList {
  /** #E by 2, row-major. */
  readonly E: number[] = [];
  private readonly keys = new Set<number>();
  private readonly vertexCount: number;

  constructor(vertexCount: number) {
    this.vertexCount = vertexCount;
  }

  get count(): number {
    return this.keys.size;
  }

  add(i: number, j: number): void {
    const key = Math.min(i, j) * this.vertexCount + Math.max(i, j); // the same in both directions
    if (this.keys.has(key)) return;
    this.keys.add(key);
    this.E.push(i, j);
  }
}
