import type { AtPoint } from '../../gradient_check.tsx';

/**
 * E with the printed pin term w/2 tr(pᵀCᵀC p) − w tr(pᵀp^target), in which every vertex has a target: J, up to what is the same for all p.
 * V: #V×3, m, where the vertices that are not pinned rest.
 */
export function printedPinEnergy({ objective, pin, p, pinned, targets, w }: AtPoint, V: Float64Array): number {
  const everywhere = V.slice();
  for (const [row, vertex] of pinned.entries()) everywhere.set(targets.subarray(3 * row, 3 * row + 3), 3 * vertex);
  let squares = 0; // m²
  for (const vertex of pinned) for (const axis of [0, 1, 2]) squares += p[3 * vertex + axis] ** 2;
  const towards = p.reduce((sum, x, c) => sum + x * everywhere[c], 0); // m²
  return objective - pin + (w / 2) * squares - w * towards;
}
