import type { equations as en } from '../en/equations.ts';
import type { Catalogue } from '../index.ts';

export const equations: Catalogue<typeof en> = {
  local: {
    title: '局部步',
    invite: '点击一根弹簧，在这里查看它的数值。',
    notYet: '还没有 d：预测只是复制 p ← pᵗ。下一个半步（局部步）才计算 d。',
    spring: '弹簧 {{index}}',
    ends: 'i = {{i}}，j = {{j}}',
    stretched: '伸长 {{percent}}',
    squeezed: '压缩 {{percent}}',
    atRest: '恰为原长',
    table: '弹簧 {{index}} 的数值，单位 {{unit}}',
    length: '长度',
    fromIteration: '取自第 {{iteration}} 次迭代的局部步',
  },
  global: {
    title: '全局步',
    invite: '点击一个质点，在这里查看它对应的那一行方程。',
    notYet: '还没有 b：没有 d 就没有 b，要先做局部步。',
    waiting: 'Qp ≠ b：p 还是旧的，下一个半步（全局步）才求解。',
    vertex: '质点 {{index}}',
    moved: '在这个全局步中移动了 {{length}}',
    table: 'Qp = b 的第 {{index}} 行，单位 {{unit}}',
    residual: '残差 ‖Qp − b‖∞ = {{value}}',
    change: '最大移动 {{length}}',
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
  },
};
