import type { en } from './en.ts';

export const zh: typeof en = {
  heading: '均匀采样',
  why: '机械臂以固定的频率逐个接收曲线上的点。两点之间间隔大，就是一次大的跳跃：末端执行器在那里必须运动得快，求解也从离目标点较远处开始。同样多的点可以有三种取法。',
  points: '点数',
  reset: '恢复默认点数',
  fewest: '这条曲线仍有 {{count}} 个点：各笔画的端点和拐角至少需要这么多。',
  choose: '机械臂使用这里选中的点。',
  names: {
    parameter: 't 等间隔',
    'arc-length': '弧长等间隔',
    curvature: '弯曲处更密',
  },
  picture: '曲线和它的 {{count}} 个点。最大间隔 {{gap}}，误差 {{error}}。',
  gap: '最大间隔',
  error: '误差',
  seen: {
    parameter: '曲线随 t 变化快的地方，点就稀疏：最大间隔是平均间隔的 {{ratio}} 倍。',
    'arc-length': '笔的速度均匀，每个拐角处都有一个点：最大间隔是平均间隔的 {{ratio}} 倍。',
    curvature: '一半的点按弧长分配，另一半按方向转过的角度分配，所以弯曲处点更多：最大间隔是平均间隔的 {{ratio}} 倍。',
  },
  errorMeaning: '误差：曲线偏离相邻采样点连线的最大距离。',
};
