import type { Catalogue } from '../../../app/messages/index.ts';
import type { en } from './en.ts';

export const zh: Catalogue<typeof en> = {
  label: '搜索的步骤',
  first: '回到搜索起点',
  iterationBack: '后退一次迭代',
  back: '后退一步',
  forward: '前进一步',
  iterationForward: '前进一次迭代',
  last: '到搜索终点',
  slider: '搜索的步骤',
  hang: '从自然下垂开始',
  hangHint: '让机械臂自然下垂，重新搜索同一目标点',
  iteration: '第 {{iteration}} 次迭代，共 {{iterations}} 次',
  happened: {
    start: '搜索起点',
    joint: '转动关节 {{joint}}',
    backward: '后向过程',
    forward: '前向过程',
    all: '所有关节同时转动',
    limit: '退回到限位之内',
    straight: '朝目标点摆直',
    bend: '先稍稍弯曲',
  },
};
