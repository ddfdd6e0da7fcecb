import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`由[三个位置](time)可得加速度。若取时间步**末端**的力，它就依赖于未知的 $\symp$，于是质点 $i$ 的牛顿定律成为关于 $\symp$ 的方程。
把各项移到一边：`,
  terms: {
    gradient: raw`三项都是某个函数对 $\symp_i$ 的导数。把这些函数之和记作 $\symobjective$，方程即为 $\symgradient = 0$，这正是谷底应满足的条件。
因此不必直接解方程，**寻找能量曲面的最低点**即可。`,
    title: '一个和式，三种愿望',
    wishes: raw`- 弹簧项 $\sympotential$：希望每根弹簧恢复原长。
- 惯性项 $\syminertia$：希望每个质点沿直线继续走到 $2\sympCurr_i - \sympPrev_i$；质量越大、步长越小，这一愿望就越强。
- 外力项 $\symexternal$：希望顺着外力走得越远越好；对重力而言就是向下。

三者不可能同时如愿。时间步的结果使下面的总和取最小值：`,
  },
  landscape: {
    shown: '等值线图显示',
    terms: { sum: '总和', springs: '弹簧项', inertia: '惯性项', external: '外力项' },
    values: '在当前的 p 处',
    caption: raw`一根弹簧，一个可动的质点：此时 $\symobjective$ 可以画成平面上的一幅地图。细线是等值线，线条越清晰，能量越低。十字：仅有惯性与重力时质点
将到达的位置。圆点：本时间步的各次迭代；圆环是最后一次。按 ½▶ 逐步走向谷底。`,
    seen: raw`请逐项查看：弹簧项是环绕固定点、半径为原长的一圈谷地，惯性项是圆形的碗，外力项是斜坡。再改变 $\symdeltaT$：步长小时，惯性的碗极陡，
其余各项几乎不起作用；步长大时，环形谷地占上风。在最后一次迭代处 $\lVert\symgradient\rVert$ 接近 0，牛顿定律在此处成立。
在实验室中可以看到[其他方法在整张网上能走多近](springs/convergence)。`,
  },
  nonlinear: {
    title: '为什么不是线性方程',
    ask: raw`加速度是 $\symp$ 的线性函数，整个方程为什么不是？`,
    hint: raw`如果导数都是线性的，$\symobjective$ 沿一条直线会是什么形状？在固定点的两侧，弹簧又是怎样的？`,
    answer: raw`原因在于长度 $\lVert\symp_i - \symp_j\rVert$ 含有平方根。线性的力所对应的能量，沿任何直线都是抛物线，只有一个最低点。让质点沿过固定点的
水平线移动：弹簧在左侧距离等于原长处能量为零，在右侧**同样**如此，两者之间还有一个尖峰。`,
    spring: '弹簧的能量',
    energy: raw`$\sympotential$，J`,
    offset: '到固定点的距离（向右为正），m',
    summary: '弹簧能量沿过固定点的直线的变化：两侧距离等于原长处为零，中间是一个尖峰。',
  },
  explicit: {
    title: '为什么不用已知的力？',
    ask: raw`若用 $\sympCurr$ 处的力代替 $\symp$ 处的力，就什么也不用解了。会发生什么？`,
    hint: raw`一根刚度很大的弹簧只要稍微拉长，就会产生很大的恢复力。如果这个力在整个时间步内保持不变，质点会冲出多远？`,
    answer: raw`每一步只需代入一个公式，这就是**显式**方法：

$$\symp_i = 2\sympCurr_i - \sympPrev_i + \frac{\symdeltaT^2}{\symm_i}\,\symf_i(\sympCurr)$$

单根弹簧上的质点以 $\omega = \sqrt{\symk/\symm}$ 振动。若 $\symdeltaT\,\omega$ 大于 2，每一步都会越过原长，而且一次比一次冲得更远。按下播放，
再减小 $\symk$ 或 $\symdeltaT$，直到它稳定为止。`,
    atStart: '取时间步始端的力',
    atEnd: '取时间步末端的力',
    reading: 't = {{time}}\n能量 {{gained}}',
    left: '质点在 t = {{time}} 时离开了画面。',
    stable: raw`$\omega = {{omega}}\,\mathrm{s}^{-1}$，$\symdeltaT\,\omega = {{product}} < 2$：**稳定**。`,
    unstable: raw`$\omega = {{omega}}\,\mathrm{s}^{-1}$，$\symdeltaT\,\omega = {{product}} \geq 2$：**不稳定**。`,
    energy: '相对于开始时的能量变化，J',
    time: '模拟时间，s',
    summary: '能量随模拟时间的变化：超过界限后，取始端的力时能量无限增长，取末端的力时则从不增长。',
    seen: raw`在界限之内，显式方法对能量的保持优于隐式方法。但一张网有多少种振动方式，就有多少个 $\omega$，其中最快的一个便决定了 $\symdeltaT$
的上限。隐式方法则对任何步长都稳定。`,
    lab: '在积分方法实验室里，让整块布同时用两种显式欧拉法和一种隐式欧拉法来算',
  },
  slips: {
    title: '原文中的 E',
    intro: raw`若对照课程讲义阅读，会看到不同的正负号。孰是孰非很容易检验：把一个质点移动一点点，看 $\symobjective$ 改变多少，再与力比较。`,
    sign: {
      title: '惯性项前的负号',
      why: raw`带负号时，导数为 $-\symm_i\syma_i - \symf_i$；令其为零，质点会向上运动。`,
    },
    half: {
      title: '惯性项缺少 ½',
      why: raw`某一版中没有 ½。平方求导会出现因子 2，没有 ½ 与之相消，每个质量就被计算了两次。`,
    },
    previous: {
      title: '更早的位置前的负号',
      why: raw`见于若干矩阵形式。静止的质点三个位置相同，惯性项理应为零；而按此式，离原点越远，能量反而越大。`,
    },
    delta_t: {
      title: 'Δt 缺少平方',
      why: raw`某一矩阵形式中除以的是 $2\symdeltaT$。单位即可判断：kg m²/s² 是能量，kg m²/s 不是。`,
    },
    external: {
      title: '外力项前缺少负号',
      why: raw`见于某一矩阵形式。$-\symp_i^{\mathrm T}\symfExt_i$ 的导数是 $-\symfExt_i$，与牛顿定律一致；缺了负号，重力就会向上拉。`,
    },
  },
  sources: {
    jacobson:
      'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Time integration as energy optimization”一节。',
    liu: 'T. Liu、A. Bargteil、J. O’Brien、L. Kavan，Fast Simulation of Mass-Spring Systems，2013：第 3 节。',
    witkin:
      'A. Witkin、D. Baraff，Physically Based Modeling（课程讲义）：“Differential Equation Basics”与“Implicit Methods”。',
    nocedal: 'J. Nocedal、S. Wright，Numerical Optimization：第 2 章，极小点的条件。',
  },
};
