/** Lengths of a time step, s: of a screen's picture, every other one of those, a film's picture, and far too long. */
export const steps = [
  { delta_t: 1 / 60, name: '1/60 s' },
  { delta_t: 1 / 30, name: '1/30 s' },
  { delta_t: 1 / 24, name: '1/24 s' },
  { delta_t: 1, name: '1 s' },
] as const;
