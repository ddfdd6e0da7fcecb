import type { Catalogue } from '../../app/messages/index.ts';
import type { en } from './en.ts';

export const zh: Catalogue<typeof en> = {
  title: '快速质点弹簧系统：从 f = ma 到七个函数',
  contents: '目录',
  section: '第 {{number}} 节',
  neighbours: '相邻的节',
  previous: '上一节',
  next: '下一节',
  sources: '参考资料',
  rooms: { matrices: '矩阵室：对实验室中打开的场景看同样的内容' },
  timingFailed: '无法计时。{{reason}}',
  slip: {
    label: '印刷有误',
    printed: '原文',
    right: '正确',
    check: '它是梯度吗？质点 {{i}} 的 ∂E/∂p，由 E 的有限差分求得，h = {{h}}，单位 {{unit}}',
    gradient: '求解器中的梯度',
    ofPrinted: '原文中 E 的差分',
    ofRight: '正确 E 的差分',
    differs: '两者不同：原文的 E 有另一个梯度。',
    agrees: '此刻两者恰好相同。让时间前进几步，或换一个在运动的质点。',
  },
  figure: {
    springs: '弹簧',
    vertices: '质点',
    spring: '弹簧 {{e}}，从质点 {{j}} 到 {{i}}，伸长 {{strain}}',
    vertex: '质点 {{i}}',
    pin: '质点 {{i}} 处的固定点，可用方向键移动',
    openInLab: '在实验室中打开',
    place: 't = {{step}} · 第 {{iteration}} 次迭代（共 {{iterations}} 次）· {{phase}}',
    playing: 't = {{step}}',
    loading: '正在载入图……',
    pictures: {
      net: '所有弹簧一起',
      torn: '每根弹簧各自',
    },
  },
};
