import type { en } from './en.ts';

export const zh: typeof en = {
  label: '绘制',
  play: '开始画',
  pause: '暂停',
  back: '上一个目标点',
  forward: '下一个目标点',
  reset: '回到第一个目标点',
  target: '图形上的目标点',
  place: '第 {{place}} / {{count}} 个目标点',
  air: '抬笔',
  errors: {
    heading: '离每个目标点多远',
    label: '末端执行器到目标点的距离，mm',
    target: '目标点',
    error: '距离',
    within: 'ε：足够近',
    summary: '{{count}} 个目标点各自与末端执行器的距离：最大 {{worst}}，在第 {{at}} 个目标点。足够近是指 {{epsilon}}。',
    said: '最大 {{worst}}，在第 {{at}} 个目标点；{{count}} 个目标点中有 {{missed}} 个的距离超过 ε = {{epsilon}}。单个目标点最多用了 {{iterations}} 次迭代。',
  },
};
