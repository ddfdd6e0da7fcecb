/** An elimination tree on paper: across in leaves, down in generations from the roots. */
export interface TreeLayout {
  /** #columns each. */
  x: Float64Array;
  depth: Int32Array;
  leaves: number;
  roots: number;
  /** Columns on the longest way from a leaf to its root. */
  height: number;
}

/** Leaves stand side by side in the order in which a walk from the roots meets them, everything else in the middle of its children. parent[c] > c, or −1 at a root. */
export function treeLayout(parent: Int32Array): TreeLayout {
  const count = parent.length;
  const depth = new Int32Array(count);
  const children: number[][] = Array.from({ length: count }, () => []);
  const roots: number[] = [];
  for (let column = count - 1; column >= 0; column--) {
    if (parent[column] < 0) roots.push(column);
    else {
      depth[column] = depth[parent[column]] + 1;
      children[parent[column]].push(column);
    }
  }
  const x = new Float64Array(count);
  let leaves = 0;
  // Down to the leaves and up again, without recursion: a tree can be as tall as the matrix.
  const walk = roots.map((column) => ({ column, entered: false })).reverse();
  for (let at = walk.pop(); at; at = walk.pop()) {
    const below = children[at.column];
    if (below.length === 0) x[at.column] = leaves++;
    else if (at.entered) x[at.column] = (x[below[0]] + x[below[below.length - 1]]) / 2;
    else {
      walk.push({ column: at.column, entered: true });
      for (let child = below.length - 1; child >= 0; child--) walk.push({ column: below[child], entered: false });
    }
  }
  const height = depth.reduce((most, generation) => Math.max(most, generation + 1), 0);
  return { x, depth, leaves, roots: roots.length, height };
}
