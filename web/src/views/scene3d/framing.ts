/** What a view of the whole scene should hold, and from how steep above. */
export interface Framing {
  /** #×3, metres. */
  points: Float64Array;
  /** Radians from +y down. */
  polar: number;
}

/** Radians from +y down: for what stands upright and for what lies flat. */
const uprightPolar = 1.35;
const flatPolar = 0.9;
/** How much of its fall a vertex makes, when its neighbours are pinned elsewhere and all lies flat. What hangs already falls less. */
const fallShare = 0.6;

/**
 * Everything at rest (V #V×3, metres), and how deep it may hang: alone, a vertex could swing down by as far as it lies aside of the nearest pin.
 * From a single pin everything does so, and to the other side too.
 */
export function framingOf(V: Float64Array, pinned: Int32Array): Framing {
  const flat = flatness(V);
  const fall = pinned.length === 1 ? 1 : fallShare * flat;
  const points = Array.from(V);
  for (let v = 0; v < V.length; v += 3) {
    const aside = (pin: number) => Math.hypot(V[v] - V[3 * pin], V[v + 2] - V[3 * pin + 2]);
    const nearest = pinned.reduce((least, pin) => Math.min(least, aside(pin)), Number.POSITIVE_INFINITY);
    if (pinned.length > 0) points.push(V[v], V[v + 1] - fall * nearest, V[v + 2]);
    if (pinned.length === 1) points.push(2 * V[3 * pinned[0]] - V[v], V[v + 1], 2 * V[3 * pinned[0] + 2] - V[v + 2]);
  }
  return { points: Float64Array.from(points), polar: uprightPolar + (flatPolar - uprightPolar) * flat };
}

/** 0: at least as high as wide … 1: flat on the ground. */
function flatness(V: Float64Array): number {
  const [width, height, depth] = [0, 1, 2].map((axis) => {
    const coordinates = V.filter((_, at) => at % 3 === axis);
    return coordinates.reduce((a, b) => Math.max(a, b)) - coordinates.reduce((a, b) => Math.min(a, b));
  });
  return Math.max(0, 1 - height / Math.max(width, depth));
}
