import type { Catalogue } from '../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`
    每个时间步都要寻找目标函数 $\symobjective$ 的最低点（[为什么](optimisation)）。局部步与全局步交替进行，逐步下降（[怎样做](trick)），
    做满 $K$ 次就停下，不论走到了哪里。它们能走多远？从同一起点出发，其他方法又能走多远？
  `,
  closed: {
    title: '差距缩小了多少',
    sentence: raw`
      在时间步 {{step}} 中，局部步与全局步迭代 **{{iterations}} 次**，使 $\symobjective$ 与所得最小值之间的差距比起初缩小了
      **{{share}}**。刚度数 **$\symkappa$ = {{kappa}}**。
    `,
    percent: '{{percent}} %',
    nearlyAll: '几乎全部（只剩 {{left}}）',
    all: '全部（只剩舍入误差）',
    computing: raw`正在求时间步 {{step}} 中 $\symobjective$ 的最小值……`,
    nothing: raw`时间步 {{step}} 没有差距可缩小：起点处 $\symobjective$ 已经最小。`,
    givenUp: raw`这个场景的一次迭代耗时较长：这里只做了 {{made}} 次，而时间步要到更晚才结束。刚度数 **$\symkappa$ = {{kappa}}**。`,
    playing: raw`正在播放。暂停后即可比较当前的时间步。`,
    why: {
      ask: raw`为什么取决于 $\symkappa$？`,
      answer: raw`
        $\symkappa$ 在每个质点处比较弹簧与惯性的强弱：

        $$\symkappa = \max_i \frac{\symdeltaT^2}{\symm_i} \sum_j \symk_{ij}$$

        弹簧以 $\symk$ 抵抗伸缩，却不抵抗转动；抵抗转动的只有惯性 $\symm/\symdeltaT^2$。全局步并不知道这一点：它固定所有的
        $\symd$，因此矩阵 $\symQ$ 抵抗转动与抵抗伸缩一样强。需要转动的部分于是移动得太少：最坏时，每次迭代大约只走完应走路程的
        $1 + \symkappa$ 分之一，在这里是 **{{oneIn}} 分之一**。而 L-BFGS 法会逐步学到 $\symobjective$ 真实的弯曲程度，牛顿法则直接用到它。

        减小 $\symk$ 或 $\symdeltaT$，可以看到局部–全局法的曲线变陡。
      `,
    },
    net: '试试“网”',
    flag: '试试硬弹簧的“旗”',
    flagHint: 'k = 100000 N/m',
  },
  levels: {
    title: '两层时钟，一层套一层',
    text: raw`
      在上面的线上，时间在前进，每格为 $\symdeltaT$。在下面的线上，时间静止不动：它是上面的一格展开而成的，在其中寻找 $\symp$。
      左边的各格已被记住；滑块右边的各格按当前的设置重新计算。
    `,
    step: '每个时间步更新',
    halfStep: '每个半步更新',
    local: '局部',
    global: '全局',
    neither: '两层都不更新',
    unless: raw`除非改变 $\symk$、$\symdeltaT$、$\symm$、$\symw$、弹簧或固定点的集合`,
  },
  damped: {
    title: '迭代太少，看上去像有阻尼',
    text: raw`
      迭代次数少时，每个时间步都在到达极小点之前停下，仍离起点 $\sympCurr$ 不远。这一步中没有移动的部分，在下一步中就没有速度
      $(\sympCurr - \sympPrev)/\symdeltaT$。能量于是损失在没有做完的求解里：公式中没有任何摩擦，网却像“陷在花生酱里”一样缓缓下沉。
      隐式欧拉法本身也有阻尼：对“网”来说，$K = 50$ 时损失的就只有这一部分。

      让三个副本从实验室的当前时刻继续运动，看看能量还剩多少。拖动一个固定点，三者一起移动。想从静止开始，请先让实验室回到静止状态。
    `,
    start: '分别迭代 1、10、50 次，开始运动',
    again: '从实验室的当前时刻重新开始',
    count: 'K = {{iterations}}',
    note: '动能 {{kinetic}}',
    energy: '动能、弹簧势能与外力势能之和，J',
    time: '时间，s',
    summary: '每个时间步迭代 1、10、50 次时，总能量随时间的变化。',
  },
};
