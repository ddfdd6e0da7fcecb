import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`
到目前为止，公式中每个质点带一个下标，每根弹簧带两个下标。这样写没有错，但写起来慢，读起来慢，算起来也慢。改用矩阵之后，对质点和弹簧的循环就变成了矩阵乘积，再经过两步代数运算，便得到全局步要求解的线性方程组。

把所有质点的位置逐行排列：$\symp$ 每个质点一行，共三列。于是所有弹簧的向量 $\symp_i - \symp_j$ 可以用一次乘法得到。矩阵 $\symA$ 每根弹簧一行，在 $i$ 列为 $+1$，在 $j$ 列为 $-1$：

$$\symv = \symA\symp$$`,
  product: {
    caption:
      '选中一根弹簧、表格的一行或一个元素：图和三张表中的同一事物会一起亮起。拖动一个质点：A 不变，p 和 v 随之变化。',
  },
  trace: {
    title: '用迹表示平方和',
    springs: raw`
矩阵 $\mathbf{X}$ 所有元素的平方和等于迹 $\operatorname{tr}(\mathbf{X}^{\mathrm T}\mathbf{X})$，因为 $\mathbf{X}^{\mathrm T}\mathbf{X}$ 的对角线上正是各列长度的平方。因此，像[上一节](trick)那样固定 $\symd$ 时，弹簧项为

$$\begin{aligned} & \sum_{ij} \tfrac12\symk\lVert(\symp_i - \symp_j) - \symd_{ij}\rVert^2 \\ & \quad = \tfrac12\symk\operatorname{tr}\bigl((\symA\symp - \symd)^{\mathrm T}(\symA\symp - \symd)\bigr) \end{aligned}$$`,
    check: '上图中的网此刻两边的数值：对弹簧求和得 {{sum}}，½k 乘以迹得 {{trace}}。',
    inertia: raw`
质量放在 $\symM$ 的对角线上，并记 $\mathbf{q} = \symp - 2\sympCurr + \sympPrev$，则惯性项为

$$\syminertia = \tfrac{1}{2\symdeltaT^2}\operatorname{tr}\bigl(\mathbf{q}^{\mathrm T}\symM\,\mathbf{q}\bigr).$$`,
  },
  collect: {
    title: '合并 p 的系数',
    text: raw`
函数取最小值处，梯度为零。平方和之迹的梯度与平方的导数一样简单：$\operatorname{tr}(\mathbf{X}^{\mathrm T}\mathbf{X})$ 的梯度是 $2\mathbf{X}$。令所有梯度之和为零，并把含 $\symp$ 的项都移到左边：

$$\begin{aligned} & \bigl(\symk\symA^{\mathrm T}\symA + \tfrac{1}{\symdeltaT^2}\symM + \symw\symC^{\mathrm T}\symC\bigr)\,\symp \\ & \quad = \symk\symA^{\mathrm T}\symd + \symy \end{aligned}$$

括号中的矩阵就是 $\symQ$，右端就是 $\symb$。在 $\symp$ 与 $\symd$ 交替更新的过程中保持不变的部分，集中在 $\symy$ 中：

$$\begin{aligned} \symy = {} & \tfrac{1}{\symdeltaT^2}\symM\,(2\sympCurr - \sympPrev) \\ & + \symfExt + \symw\symC^{\mathrm T}\symC\,\sympTarget \end{aligned}$$

$$\symQ\symp = \symb$$

$\symC$ 和 $\symw$ 与固定点有关，详见[第 9 节](pins)。`,
    caption: '逐项打开或关闭 Q 的各项。哪一项会在对角线之外产生非零元？',
    terms: 'Q 的各项',
    springs: '弹簧',
    masses: '质量',
    pins: '固定点',
  },
  constants: {
    ask: raw`把 $\symsurrogate$ 展开，还有一些不含 $\symp$ 的项，例如 $\tfrac12\symk\operatorname{tr}(\symd^{\mathrm T}\symd)$。为什么没有人费心把它们写出来？`,
    hint: raw`把一座山谷整个抬高十米，最低点会移到哪里？`,
    answer: raw`因为要找的是最低点的位置，而不是它的高度。常数项只把整条曲线抬高；它的导数为零，所以 $\symQ$ 和 $\symb$ 都与它无关。剩下的是

$$\tfrac12\operatorname{tr}(\symp^{\mathrm T}\symQ\symp) - \operatorname{tr}(\symp^{\mathrm T}\symb)$$

下图固定 $\symd$，让质点 1 上下移动，画出了这两条曲线。`,
    caption: '继续前进，或拖动质点 1：曲线会变，两者的间距也会变，最低点的位置却始终相同。',
    whole: '含常数项',
    left: '不含常数项',
    x: '质点 1 高出当前位置的距离，m',
    y: raw`$\symsurrogate$，J`,
    summary: '两条抛物线，一条恰好在另一条的正上方。',
    difference: '常数项共计 {{difference}}，与质点 1 的位置无关。',
  },
  changes: {
    ask: raw`拖动一个质点时，$\symA$、$\symM$、$\symQ$、$\symp$、$\symd$ 和 $\symb$ 中哪些会改变？改变 $\symk$ 时又有哪些会改变？`,
    hint: raw`在它们各自的定义中找一找 $\symp$。`,
    answer: raw`$\symA$、$\symM$ 和 $\symQ$ 都不知道质点此刻在哪里。$\symQ$ 只取决于弹簧、$\symk$、质量、$\symdeltaT$、固定点的集合以及 $\symw$，在各个时间步之间保持不变，所以值得只分解一次。拖动时，先是 $\symp$ 改变，$\symd$ 在下一个局部步随之改变，右端 $\symb$ 又随 $\symd$ 改变。改变 $\symk$ 时，$\symQ$ 和 $\symb$ 立即改变，$\symp$ 和 $\symd$ 随后改变。不妨在下面试一试这两种操作。`,
    caption: '最近一次操作改变了的量会被标出。',
    changed: '已改变',
    same: '未改变',
  },
  laplacian: {
    ask: raw`$\symA^{\mathrm T}\symA$ 的第 $i$ 行是什么？`,
    hint: raw`元素 $(i, j)$ 是 $\symA$ 的两列之积：逐根检查弹簧，看哪里两列都不为零。`,
    answer: raw`对角线上是质点 $i$ 所连弹簧的根数，每根弹簧贡献 $(\pm1)^2$。对角线之外，凡与 $i$ 有弹簧相连的质点处为 $-1$，其余为零。每一行之和都等于零。在其他领域，这个矩阵叫作**图拉普拉斯矩阵**。在上面 $\symQ$ 的表格中只打开弹簧项，看到的就是它的 $\symk$ 倍。下面是九个质点的网：`,
    caption: '指向表格旁的编号，对应的质点就会亮起。数一数它的弹簧。',
  },
  columns: {
    ask: raw`为什么用三列，而不用一个含 $3n$ 个元素的长向量（$n$ 为质点数）？`,
    hint: raw`一个质点的 $x$ 会出现在另一个质点的 $y$ 方程中吗？`,
    answer: raw`固定 $\symd$ 之后不会：$\symQ\symp = \symb$ 的三列是系数矩阵相同的三个方程组。一次分解可供三列共用，矩阵的宽度也只有三分之一。牛顿法就没有这样的好事：$x$、$y$、$z$ 相互耦合，矩阵是 $3n \times 3n$ 的，而且每次迭代都要重新形成。沿一个坐标轴推一个质点，比较两者的响应：`,
    caption: '沿 x 推：全局步在 y 方向上毫无移动。让时间前进：全局步的响应不变，牛顿法的响应会变。',
    push: '以 {{force}} N 的力推质点 {{vertex}}，方向为',
    global: '全局步（固定 d）：各质点的位移，mm',
    newton: '牛顿法的一步，mm',
  },
  sources: {
    jacobson: 'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Matrices”一节，迹与全局步。',
    liu: 'T. Liu、A. Bargteil、J. O’Brien、L. Kavan，Fast Simulation of Mass-Spring Systems，2013：第 4 节，逐根弹簧地引入 A 与拉普拉斯矩阵。',
    boyd: 'S. Boyd、L. Vandenberghe，Introduction to Applied Linear Algebra：第 7 章，关联矩阵；第 12 章，最小二乘。',
  },
};
