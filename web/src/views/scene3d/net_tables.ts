import { Table } from './table.ts';
import type { Scene3DFrame } from './types.ts';

/** What the shaders of both views read alike. */
export class NetTables {
  /** #E×2: the vertices that a spring joins. */
  readonly springs = new Table(2);
  /** #pinned×2: the vertex that a pin holds, and the pin's row in `targets`. */
  readonly pins = new Table(2);
  /** #pinned×3, metres. */
  readonly targets = new Table(3);

  constructor(E: Int32Array) {
    this.springs.set(E);
  }

  setPins({ pinned, targets }: Pick<Scene3DFrame, 'pinned' | 'targets'>): void {
    const rows = this.pins.write(pinned.length);
    pinned.forEach((vertex, row) => {
      rows[2 * row] = vertex;
      rows[2 * row + 1] = row;
    });
    this.targets.set(targets);
  }

  dispose(): void {
    for (const table of [this.springs, this.pins, this.targets]) table.dispose();
  }
}
