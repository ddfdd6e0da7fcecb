import type { Sampling } from '../../../curves/sampling.ts';

export const en = {
  heading: 'Even sampling',
  why: 'The arm is given one point of the curve after the other, all at the same rate. A large gap between two points is a large jump: there the end effector has to be fast, and the search begins far from its target. The same number of points can be placed in three ways.',
  points: 'Number of points',
  reset: 'Back to the usual number',
  fewest: 'This curve has {{count}} points all the same: the ends of its strokes and its corners need as many.',
  choose: 'The arm uses the points that are chosen here.',
  names: {
    parameter: 'Equal steps of t',
    'arc-length': 'Equal arc lengths',
    curvature: 'Closer where it bends',
  } satisfies Record<Sampling, string>,
  picture: 'The curve with {{count}} points. Largest gap {{gap}}, error {{error}}.',
  gap: 'Largest gap',
  error: 'Error',
  seen: {
    parameter:
      'Where the curve moves fast in t, its points lie far apart: the largest gap is {{ratio}} times the average one.',
    'arc-length':
      'The pen moves at an even speed, with a point in every corner: the largest gap is {{ratio}} times the average one.',
    curvature:
      'Half of the points go by length, the other half by how far the direction turns, so bends get more of them: the largest gap is {{ratio}} times the average one.',
  } satisfies Record<Sampling, string>,
  errorMeaning: 'Error: how far the curve departs from the straight lines between its points.',
};
