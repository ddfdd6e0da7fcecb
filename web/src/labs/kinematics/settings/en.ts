/** Texts of the arm's settings. */
export const en = {
  heading: 'Settings',
  methods: {
    label: 'Method',
    ccd: 'CCD',
    fabrik: 'FABRIK',
    'least-squares': 'Least squares',
  },
  arm: {
    heading: 'The arm',
    presets: {
      lab: 'The lab’s arm',
      two: 'Two equal links',
      ten: 'Ten short links',
      hole: 'Never near its root',
    },
    presetHints: {
      lab: 'Links of 0.8, 0.4, 0.2 and 1.2 m',
      two: 'Two links of 1.3 m',
      ten: 'Ten links of 0.26 m',
      hole: 'Links of 0.3, 2 and 0.5 m: the end effector stays at least 1.2 m from the root',
    },
    rootHeight: 'height of the root',
  },
  links: {
    link: 'joints',
    length: 'length',
    bend: 'most bend',
    between: '{{from}} – {{to}}',
    lengthOf: 'Length of the link from joint {{from}} to joint {{to}}',
    bendOf: 'Most bend at joint {{joint}}',
    bendHint:
      'The most bend is the largest angle between a link at its joint and the direction of the link before, or at the root straight down. Empty: as far as it likes.',
    remove: 'Remove the link from joint {{from}} to joint {{to}}',
    add: 'Add a link',
  },
  search: {
    heading: 'The search',
    iterations: 'most iterations',
    epsilon: 'tolerance',
    reset: 'back to the usual value',
    turn: 'most turn of a joint for one target',
    turnHint: 'Counted from where the search began. Empty: as far as it likes.',
    precision: 'precision',
    double: 'double',
    single: 'single',
    precisionHint:
      'In single precision an angle taken from its cosine is lost below about 5·10⁻⁴ rad; in double precision, with atan2, it is not.',
  },
};
