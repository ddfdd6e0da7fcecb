import type { methods as en } from '../en/methods.ts';
import type { Catalogue } from '../index.ts';

export const methods: Catalogue<typeof en> = {
  label: '方法',
  name: {
    'local-global': '局部–全局法',
    chebyshev: '切比雪夫加速',
    anderson: '安德森加速',
    lbfgs: 'L-BFGS 法',
    newton: '牛顿法',
    'linearly-implicit': '线性隐式欧拉法',
    'symplectic-euler': '辛欧拉法',
    'forward-euler': '前向欧拉法',
  },
  explained: {
    'local-global': '每次迭代只做一个局部步和一个全局步：单次迭代最省，E 从不上升，但可能需要上千次迭代。',
    chebyshev:
      '把局部–全局法的每个迭代点沿上一次移动的方向再外推一段，外推系数由各次移动缩小的快慢得出；只多几次向量加法（Wang 2015）。',
    anderson:
      '把最近六个局部–全局迭代点线性组合，使剩余的修正量尽量抵消；多几次向量内积，且仅当 E 下降时才采用（Peng 等 2018）。',
    lbfgs:
      '以全局步为方向，按最近五次迭代中梯度的变化加以修正，再做线搜索；多几次向量内积，所需迭代次数却少得多（Liu 等 2017）。',
    newton: '用 E 的精确二阶导数矩阵代替 Q；只需几次迭代即可到达极小点，但每次都要重新组装并分解一个矩阵。',
  },
  stop: {
    label: '时间步结束于',
    never: 'K 次迭代之后',
    stop_gradient: 'E 的梯度 ≤ ε 时，至多 K 次',
    stop_decrease: 'E 的相对下降量 ≤ ε 时，至多 K 次',
    tolerance: '容差 ε',
  },
};
