import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`
把弹簧拉长要做功，松手后它会把功还回来。弹簧储存的这部分能量就是**势能**。服从胡克定律的弹簧，其势能与伸长量的平方成正比：

$$\tfrac12\,\symk\,\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2$$

起作用的只是长度与原长之差：缩短 1 cm 和伸长 1 cm，储存的能量一样多。把所有弹簧的能量加起来，就得到整张网的势能：

$$\sympotential = \sum_{ij} \tfrac12\,\symk\,\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2$$`,
  force: {
    title: '由能量求力',
    text: raw`
弹簧总是朝能量下降最快的方向拉：力等于**负**梯度。长度 $\lVert \symp_i - \symp_j \rVert$ 对 $\symp_i$ 求导，得到由 $j$ 指向 $i$ 的单位向量，于是端点 $i$ 受到的力为

$$\begin{aligned} & -\frac{\partial \sympotential}{\partial \symp_i} \\ & \quad = -\,\symk\,\underbrace{\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)}_{\text{伸长量}}\;\underbrace{\frac{\symp_i - \symp_j}{\lVert \symp_i - \symp_j \rVert}}_{\text{方向}} \end{aligned}$$

端点 $j$ 受到的力大小相等、方向相反。力的大小：每伸长一米为 $\symk$ 牛顿。力的方向：沿着弹簧，过长时拉向另一端，过短时推离另一端。`,
  },
  closest: {
    title: '最近的向量',
    text: raw`
这个能量还有另一种看法，整个方法正由此而来。在所有长度为 $\symr$ 的向量 $\symd$ 中（图中的圆，在空间中是球面），找出离 $\symp_i - \symp_j$ 最近的一个。它与弹簧方向相同，二者相差的恰好就是伸长量：

$$\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2 = \min_{\lVert \symd \rVert = \symr_{ij}} \lVert (\symp_i - \symp_j) - \symd \rVert^2$$

带根号的长度，就这样变成了两个向量之间的距离。[第 5 节](trick)将用到它。`,
    caption: '拖动质点 1。圆上是所有长度等于原长的向量，粗线是其中最近的一个，虚线间隙就是伸长量。',
    length: '长度',
    rest: '原长',
    gap: '间隙',
    fromGap: '½k · 间隙²',
    fromSolver: '求解器给出的能量',
  },
  collapsed: raw`
如果两端重合呢？这时圆上的每个向量都同样近，弹簧没有确定的方向。求解器取定一个固定方向，因此结果总是确定的，绝不会出现“非数”（NaN）。`,
  quadratic: {
    ask: raw`公式里是平方，那么能量是不是 $\symp$ 的二次函数，也就是抛物线？`,
    hint: raw`让弹簧的一端沿直线滑向另一端，穿过去，再从另一侧滑出。能量在几处为零？`,
    answer: raw`不是。能量在**两侧**各有一处为零，即左右距离均为 $\symr$ 的位置；中间两端重合处是一个尖峰。而抛物线只有一个最低点。如果把最近的向量 $\symd$ 固定下来，剩下的 $\tfrac12\symk\lVert(\symp_i-\symp_j)-\symd\rVert^2$ 才是真正的抛物线：它在一侧与能量曲线重合，在另一侧位于其上方。`,
    summary:
      '横轴为一个端点的位置，图中有两条曲线。弹簧能量有两个最低点，中间有一个尖峰；固定 d 时的抛物线在右侧与它重合，在左侧位于它上方。',
    x: raw`沿直线的 $\symp_i - \symp_j$，m`,
    y: raw`能量，J`,
    energy: '弹簧',
    parabola: '固定 d',
    caption: '把质点 1 拖过质点 0，拖到另一侧：图中的竖线标出弹簧此刻的长度。改变 k：两条曲线都随之升高。',
  },
  sign: {
    ask: raw`你的网一碰就飞散，而你确信公式没有错。首先应该检查哪个符号？`,
    hint: raw`梯度指向能量增大的方向。`,
    answer: raw`如果把力写成**正**梯度，过长的弹簧会被推得更长，伸长愈演愈烈。这种笔误不必推导就能查出来：把一个质点移动 $\pm 10^{-5}$ m，看能量变化多少，再除以位移。拖动时，下表对质点 1 做的正是这件事。`,
    caption: '拖动质点 1，比较各行数值。',
    table: '质点 1 处，N',
    formula: '由公式得到的力',
    differences: '能量差商取负',
    wrong: '能量差商取正',
  },
  sources: {
    jacobson:
      'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Mass-Spring Systems”一节，势能与力；“Time integration as energy optimization”一节，最近的向量。',
    liu: 'T. Liu、A. Bargteil、J. O’Brien、L. Kavan，Fast Simulation of Mass-Spring Systems，2013：第 4 节，关于胡克定律的引理。',
    nocedal: 'J. Nocedal、S. Wright，Numerical Optimization：第 8 章，有限差分。',
  },
};
