import type { Axis } from '../../../notation/symbols.ts';

export const matrices = {
  along: {
    '#E': 'springs',
    '#V': 'vertices',
    '#pinned': 'pins',
    '2': 'ends i, j',
    '3': 'x, y, z',
    '3#V': 'coordinates',
    '3#free': 'free coordinates',
    '#joints': 'joints',
    '#links': 'links',
    '4': 'x, y, z, w',
    '3#links': 'turns of the joints',
  } satisfies Record<Axis, string>,
  inUnit: '{{axes}}, in {{unit}}',
  spring: 'spring {{index}}',
  coordinate: 'vertex {{index}}, {{coordinate}}',
  vertex: 'vertex {{index}}',
  entry: '{{code}}, {{row}}, {{column}}: {{value}}',
  component: '{{code}}, {{row}}: {{value}}',
  product: 'Point at a row to see how it comes about.',
};
