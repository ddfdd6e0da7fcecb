import type { equations as en } from '../en/equations.ts';
import type { Catalogue } from '../index.ts';

export const equations: Catalogue<typeof en> = {
  local: {
    title: '局部步',
    invite: '点击一根弹簧，在这里查看它的数值。',
    notYet: '还没有 d：预测只是让 p 从当前位置出发。下一个半步（局部步）才计算 d。',
    spring: '弹簧 {{index}}',
    ends: 'i = {{i}}，j = {{j}}',
    stretched: '伸长 {{percent}}',
    squeezed: '压缩 {{percent}}',
    atRest: '恰为原长',
    table: '弹簧 {{index}} 的数值，单位 {{unit}}',
    length: '长度',
    fromIteration: '这里是第 {{iteration}} 次迭代中局部步的数值。',
  },
  global: {
    title: '全局步',
    invite: '点击一个质点，在这里查看它对应的那一行方程。',
    notYet: '还没有 b：没有 d 就没有 b，要先做局部步。',
    pinned: '精确固定：这一行不参与求解，Qp − b 就是固定点的力。',
    waiting: 'b 已更新，下一个半步（全局步）才求解 p。',
    method: {
      chebyshev: '切比雪夫加速沿上一次移动的方向越过 Qp = b 的解，因此 Qp − b 不为 0。',
      anderson: '安德森加速把 Qp = b 的解与前几次迭代的解线性组合，因此 Qp − b 不为 0。',
      lbfgs: 'L-BFGS 法只以 Qp = b 的解为初始方向，再按前几次迭代加以修正，因此 Qp − b 不为 0。',
      newton: '牛顿法用 E 的二阶导数矩阵代替 Q 求解，因此 Qp − b 不为 0。',
    },
    vertex: '质点 {{index}}',
    moved: '移动了 {{length}}',
    table: 'Qp = b 的第 {{index}} 行，单位 {{unit}}',
    residual: '残差',
  },
  thisHalfStep: '当前半步',
  known: '已知',
  unknown: '未知',
  legend: '公式中的符号',
  card: {
    shape: '形状',
    unit: '单位',
    value: '当前值',
    code: '代码中',
    number: '一个数',
    dimensionless: '无',
    lesson: '课程第 {{number}} 节：{{title}}',
  },
};
