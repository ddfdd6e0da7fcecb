/** The lesson's sections, in the order in which they are read. */
export const sectionIds = [
  'model',
  'energy',
  'time',
  'optimisation',
  'trick',
  'matrices',
  'solving',
  'sparse',
  'pins',
  'tasks',
] as const;

export type SectionId = (typeof sectionIds)[number];
