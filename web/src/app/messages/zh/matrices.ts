import type { matrices as en } from '../en/matrices.ts';
import type { Catalogue } from '../index.ts';

export const matrices: Catalogue<typeof en> = {
  along: {
    '#E': '弹簧',
    '#V': '质点',
    '#pinned': '固定点',
    '2': '端点 i、j',
    '3': 'x、y、z',
    '3#V': '坐标',
    '3#free': '自由坐标',
    '#joints': '关节',
    '#links': '连杆',
    '4': 'x、y、z、w',
    '3#links': '各关节的转动分量',
  },
  inUnit: '{{axes}}，单位 {{unit}}',
  spring: '弹簧 {{index}}',
  coordinate: '质点 {{index}} 的 {{coordinate}} 坐标',
  vertex: '质点 {{index}}',
  entry: '{{code}}，{{row}}，{{column}}：{{value}}',
  component: '{{code}}，{{row}}：{{value}}',
  product: '指向某一行，看它是怎样算出来的。',
};
