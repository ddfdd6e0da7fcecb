export const measures = ['height', 'energy', 'time'] as const;
export type Measure = (typeof measures)[number];
