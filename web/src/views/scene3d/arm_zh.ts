import type { en } from './arm_en.ts';

export const zh: typeof en = {
  canvas: '机械臂、目标点，以及机械臂在上面绘图的地面',
  hint: '拖动目标点：在画面平面内移动；拖动它的投影：在水平面内移动；拖动别处：转动视角。',
  penHint: '在地面上绘制，每一笔都会加入曲线。按住 Shift 拖动可转动视角。',
  grid: '网格 {{step}}',
  draw: '在地面上手绘',
  clear: '清除',
  target: '目标点位于 x {{x}}、y {{y}}、z {{z}} 米。',
  targetKeys: '方向键在画面平面内移动目标点，Page Up 移远，Page Down 移近；按住 Shift 时步长为十倍。',
  pen: '画笔位于 x {{x}}、y {{y}} 米，{{state}}。',
  penDown: '已落笔',
  penUp: '已抬笔',
  penKeys: '方向键移动画笔，按住 Shift 时步长为十倍；空格键落笔或抬笔；回车键结束手绘。',
  report: '{{place}}{{outcome}}',
  outcome: {
    CONVERGED: '已到达，误差 {{error}}。',
    STALLED: '无法再靠近，还差 {{error}}。',
    UNREACHABLE: '够不到：末端还差 {{error}}。',
    MAX_ITERATIONS: '迭代次数已用完，还差 {{error}}。',
  },
};
