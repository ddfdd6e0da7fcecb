import type { plots as en } from '../en/plots.ts';
import type { Catalogue } from '../index.ts';

export const plots: Catalogue<typeof en> = {
  title: '目标函数随半步的变化',
  height: '固定 d 时的目标函数，高出本时间步最低值的部分（J，对数刻度）',
  halfStep: '半步',
  label: '时间步 {{step}} 的目标函数：已记录 {{count}} 个半步，最高处比最低值高 {{highest}}。全部数值见下方表格。',
  invite: '暂停后可以看到每个半步如何使目标函数下降。',
  stale: '播放中：图中是时间步 {{step}}。暂停后显示当前时间步。',
  atLowest: '未画出（对数轴没有零点）：半步 {{list}}，在舍入误差内就是最低值。',
  inspect: '要读数的半步',
  inspectHelp: '用方向键选择半步，按回车键跳到该处。',
  place: '半步 {{halfStep}} · 第 {{iteration}} 次迭代 · {{phase}}',
  drop: '本半步的变化',
  objective: '目标函数 E(p)',
  surrogate: '固定 d 时的目标函数',
  potential: '弹簧势能',
  inertia: '惯性项',
  external: '外力项',
  pin: '固定点项',
  residual: 'Qp = b 的残差',
  change: '最大移动',
  data: '全部半步的数值表',
  download: '下载 CSV',
};
