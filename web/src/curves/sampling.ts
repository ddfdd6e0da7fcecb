/** How a curve's points are spread: evenly in its parameter, in its length, or closer together where it bends. */
export const samplings = ['parameter', 'arc-length', 'curvature'] as const;
export type Sampling = (typeof samplings)[number];
