import type { Catalogue } from '../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  heading: '精度的阶：一根弹簧，越来越短的步长',
  intro: raw`把 $\symdeltaT$ 减半，误差会减小多少？这就是**阶**的含义：一阶方法的误差减半，二阶方法的误差减为四分之一。在双对数坐标下，当 $\symdeltaT$ 足够小时，误差随 $\symdeltaT$ 的变化是一条直线，其斜率就是阶。`,
  running: '一根弹簧正在走几万个时间步……',
  failed: '实验无法运行。{{reason}}',
  again: '重试',
  cases: { label: '弹簧的运动', line: '沿直线', swing: '摆动' },
  setting: {
    line: raw`质量为 1 kg 的质点系在一根弹簧上，弹簧另一端固定，没有重力。把质点拉长 0.2 m 后由静止释放，它沿弹簧方向振动，周期为 1 s，位置有精确解：$x(t) = r + x_0\cos\omega t$。每种方法分别用 16、32、64……2048 个时间步算到 $T = 5/8\,\mathrm{s}$。这个时刻是特意选的：前向欧拉法和隐式欧拉法的误差主项与 $\cos\omega T$ 成正比，辛欧拉法的误差主项与 $\sin\omega T$ 成正比；若这个因子恰好为 0（例如四分之一周期或半个周期时），一阶方法看上去就像更高阶的方法。`,
    swing: raw`加上重力，并换成 400 N/m 的较硬弹簧：弹簧原长 1 m，从水平位置由静止释放，质点下落，弹簧随之转动。质点在 $T = 0.8\,\mathrm{s}$ 时的位置没有公式可用，误差相对于参考解来度量：让辛欧拉法的第一步只受一半的力，它就成为二阶的 Störmer–Verlet 方法；分别走 8192 步和 16384 步，再外推到 $\symdeltaT = 0$。步数再加一倍，参考解的变化不到 $10^{-9}\,\mathrm{m}$。`,
  },
  seen: {
    line: raw`所有方法都是一阶，辛欧拉法也不例外：它的长处在于能量。其中三种方法是同一条线：只要弹簧不转动，[局部步](trick)一次就求得正确的 $\symd$，$\symobjective$ 是抛物线，解一次方程组就到达最小值。`,
    swing: raw`除最长的那个步长外，局部–全局迭代 10 次与牛顿法一样好。只迭代 1 次得到的却是另一个答案：即使在最短的步长下，它的误差仍约为隐式欧拉法的三十倍。它的误差确实随 $\symdeltaT$ 趋于零，但要到那里斜率才接近 1。原因是：$\symQ$ 把弹簧的横向刚度当作与纵向一样大，所以每个时间步的这一次迭代都把横向速度除以 $1 + \symdeltaT^2\symk/\symm$，相当于模型中并不存在的、速率为 $\symdeltaT\,\symk/\symm$ 的摩擦。第二次迭代会补上这一差额，只留下消失得快得多的余项：它的线陡然落到隐式欧拉法的线上。`,
  },
  errors: {
    heading: '误差与步长',
    slope: '斜率 {{slope}}',
    delta_t: raw`$\symdeltaT$，s`,
    error: 'T 时刻与正确位置的距离，m',
    summary: '各方法的误差随步长的变化，两轴均为对数坐标。各线向右上升，斜率见表格。',
    caption: '斜率（由最短的四个步长拟合）',
    method: '方法',
    order: '斜率',
    finest: '最短步长的误差',
  },
  energy: {
    heading: '沿直线振动时的能量',
    text: raw`这里的能量可以手算。每个时间步，前向欧拉法把能量乘以 $1 + \symdeltaT^2\omega^2$，隐式欧拉法则除以同一个数（[课程中的方法为何会减速](time)）。只要 $\symdeltaT\,\omega < 2$，辛欧拉法就始终把能量保持在初值的 $1/(1 + \tfrac12\symdeltaT\omega)$ 倍到 $1/(1 - \tfrac12\symdeltaT\omega)$ 倍之间（[超过之后会怎样](optimisation)）。`,
    product: '步长，Δt·ω',
    productText: 'Δt·ω = {{product}}',
    limit: '辛欧拉法的上限：2',
    stable: '每个周期 {{steps}} 个时间步。',
    unstable: '每个周期 {{steps}} 个时间步：Δt·ω 达到 2 及以上时，辛欧拉法也会发散。',
    time: '模拟时间，周期',
    ratio: '能量与初始能量之比',
    summary: '五个周期内的能量：前向欧拉法上升，隐式欧拉法下降，辛欧拉法在一定范围内摆动。',
    caption: '能量的变化',
    method: '方法',
    measured: '实测',
    predicted: '预测',
    methods: {
      'forward-euler': '前向欧拉',
      'symplectic-euler': '辛欧拉',
      newton: '隐式欧拉',
    },
    aStep: '每步 × {{factor}}',
    aPeriod: '每周期 × {{factor}}',
    band: '初值的 {{least}} 至 {{most}} 倍',
    unbounded: '无上限',
  },
};
