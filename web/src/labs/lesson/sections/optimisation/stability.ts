/** 1/s: how fast a mass on one spring swings along it. */
export function angularFrequency(k: number, m: number): number {
  return Math.sqrt(k / m);
}

/** J: so much more energy than at the start is no swing of the energy any more. */
export const exploded = 1e4;
