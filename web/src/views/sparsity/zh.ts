import type { Catalogue } from '../../app/messages/index.ts';
import type { en } from './en.ts';

export const zh: Catalogue<typeof en> = {
  role: '矩阵',
  closer: '放大',
  farther: '缩小',
  fit: '显示整个矩阵',
  keys: '方向键在非零元素间移动，按住 Shift 则逐格移动；Page Up 与 Page Down 换行；加号、减号和 0 缩放；回车选中。',
  invite: '指向一个元素。Ctrl 加滚轮或双指缩放，拖动平移。',
};
