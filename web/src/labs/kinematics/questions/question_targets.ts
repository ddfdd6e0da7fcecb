/** The curves that the questions are asked along. */
export const questionCurves = ['circle', 'heart'] as const;
export type QuestionCurve = (typeof questionCurves)[number];

/** m, from the middle: at the angle t, rad. */
const radii: Record<QuestionCurve, (t: number) => number> = {
  circle: () => 0.6,
  heart: (t) => 0.5 * (1 - Math.sin(t)),
};

/** #T×3, m: so many targets on the plane y = 0, evenly in the curve's parameter, beginning at the top. [P] */
export function questionTargets(curve: QuestionCurve, count: number): Float64Array {
  const targets = new Float64Array(3 * count);
  for (let at = 0; at < count; at++) {
    const t = Math.PI / 2 + (2 * Math.PI * at) / count;
    const radius = radii[curve](t);
    targets.set([radius * Math.cos(t), 0, -radius * Math.sin(t)], 3 * at);
  }
  return targets;
}
