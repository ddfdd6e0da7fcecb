/** m: between which distances from the root an end effector can be. */
export interface Shell {
  /** 0, unless one link is longer than all others together. */
  nearest: number;
  farthest: number;
}

/** Of a chain with these links, stretched: Σ ℓ; folded over its longest link: 2 max ℓ − Σ ℓ. `lengths`: m. */
export function shellOf(lengths: readonly number[]): Shell {
  const farthest = lengths.reduce((sum, length) => sum + length, 0);
  return { nearest: Math.max(0, 2 * Math.max(...lengths) - farthest), farthest };
}

/** m: how far a target at this distance from the root stays from the end effector at the least. */
export function leastError(distance: number, { nearest, farthest }: Shell): number {
  return Math.max(0, distance - farthest, nearest - distance);
}
