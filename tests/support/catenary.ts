/** A chain of n point masses between two fixed ends at one height, joined by springs that rest at the ends' distance. */
interface HangingChain {
  n: number;
  /** m: rest length of each spring; the ends are n − 1 of them apart. */
  spacing: number;
  /** kg each. */
  mass: number;
  /** N/m. */
  k: number;
  /** m/s². */
  gravity: number;
}

/**
 * Its equilibrium, #V×3 in metres, by following the tension from end to end. The horizontal tension H is the same in
 * every spring; the vertical one starts at half the weight of the masses between the ends and falls by one weight at
 * each. H is searched for until the chain spans the distance.
 */
export function catenary({ n, spacing, mass, k, gravity }: HangingChain): number[] {
  const hang = (H: number): number[] => {
    const p = [0, 0, 0];
    for (let e = 0; e < n - 1; e++) {
      const vertical = -(((n - 2) / 2 - e) * mass * gravity); // N, downwards first
      const tension = Math.hypot(H, vertical);
      const length = spacing + tension / k;
      p.push(p[3 * e] + (length * H) / tension, p[3 * e + 1] + (length * vertical) / tension, 0);
    }
    return p;
  };
  let [low, high] = [0, k * spacing * n]; // N
  for (let halving = 0; halving < 100; halving++) {
    const H = (low + high) / 2;
    if (hang(H)[3 * (n - 1)] < (n - 1) * spacing) low = H;
    else high = H;
  }
  return hang(high);
}
