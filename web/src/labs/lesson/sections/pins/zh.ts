import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`
总要有什么东西把网挂住，否则它会一直下落。**固定点**停在目标位置上，拖动时则跟随目标。怎样把这一点告诉线性方程组？

最简单的办法是**罚函数**：在质点与目标之间加一根原长为零、刚度极大的弹簧。这样能量中就多了一个平方项，其权重 $\symw$ 远大于 $\symk$：

$$\sympinEnergy = \tfrac12 \symw \sum_{i\;\text{固定}} \lVert \symp_i - \sympTarget_i \rVert^2$$

要写成不带下标的形式，可以用 $\symC$ 挑出固定点所在的行：每个固定点对应一行，只在它自己的列上有一个 $1$。于是 $\symC\symp$ 恰好就是各固定点的位置。求梯度后，矩阵中增加 $\symw\symC^{\mathrm T}\symC$，右端增加 $\symw\symC^{\mathrm T}\symC\,\sympTarget$。`,
  caption: '改变 w：Q 中只有一个元素在变，即固定点的对角元。拖动固定点：Q 完全不变。',
  weak: {
    title: '罚函数只能近似固定',
    text: raw`
弹簧要施加拉力，就必然长于原长，这一根也不例外：固定点会偏移，直到它的拉力与网的其余部分平衡，偏移量等于力除以 $\symw$。当 $\symw = 10^{10}\,\text{N/m}$ 时，偏移大约只有百万分之一毫米；$\symw$ 较小时，肉眼就能看出它下垂。

为什么不取更大的值？分解本身并不在意：对角线上有一个特别大的数，只相当于一次缩放。受影响的是固定点上的力，它等于 $\symw$ 乘以两个位置之差。双精度浮点数只有 16 位有效数字，1 m 左右的位置有 $10^{-16}$ m 的舍入误差，于是这个力以及梯度和能量，都只能精确到 $\symw \cdot 10^{-16}$ m 左右。$\symw$ 大到一定程度，就再也无法判断迭代是否已经收敛。`,
    drift: '固定点的偏移',
    force: '固定点处的力，即 w 乘以偏移',
    rounding: '其舍入误差约为',
  },
  elimination: {
    title: '或者把它们消去',
    text: raw`
另一种办法是**消元**。固定点并不是未知数，可以把它所在的行和列从 $\symQ$ 中划去；这一列本来要乘的位置是已知的，因此移到右端。方程组变小了，条件数变好了，固定点也精确不动。代价是：多一个或少一个固定点，矩阵的大小和非零结构都会改变，而罚函数只改动对角线上的一个数。

实验室默认采用消元，因为它更快。一旦你选定了 $\symw$，实验室就改用罚函数，让你看到它的作用。`,
    caption: '同一个三角形，没有 w：Q 剩下的部分和被划去的部分。',
    left: 'Q，划去固定点所在的行和列',
  },
  every: {
    ask: raw`罚项是加到 $\symQ$ 的每个元素上，还是只加到某些行上？`,
    hint: raw`$\symC^{\mathrm T}\symC$ 的元素是 $\symC$ 的第 $a$ 列与第 $b$ 列之积。它什么时候不为零？`,
    answer: raw`只加到个别元素上：每个固定点对应一个对角元。除了固定点 $i$ 的 $(i, i)$ 处为 $1$ 之外，$\symC^{\mathrm T}\symC$ 全为零。右端也只有固定点所在的行有增加。两张表把这些都列了出来。`,
    caption: raw`$\symC$ 的行数等于固定点数；$\symC^{\mathrm T}\symC$ 与 $\symQ$ 一样大。`,
  },
  product: {
    ask: raw`$\symC$、$\symC^{\mathrm T}$ 还是 $\symC^{\mathrm T}\symC$？不查书，怎样判断哪里该用哪一个？`,
    hint: raw`把各自的行数和列数写出来。`,
    answer: raw`$\symC$ 的大小是 #pinned × #V，可以左乘有 #V 行的矩阵（$\symC\symp$：挑出）；$\symC^{\mathrm T}$ 可以左乘有 #pinned 行的矩阵（放回原来的行）。只有 $\symC^{\mathrm T}\symC$ 是 #V × #V 的，能与 $\symA^{\mathrm T}\symA$ 相加。如果目标位置存成 #pinned 行的列表，右端就应该是 $\symw\symC^{\mathrm T}$ 乘以这个列表。动手乘一乘，看哪些能相乘：`,
    caption: '六个乘积中有三个可以相乘。其中两个像 Q p 和 b 一样，每个质点各有一行：哪一个用在哪里？',
    left: '左边',
    right: '右边',
    positions: 'p，每个质点一行',
    list: '目标位置，每个固定点一行',
    fits: '{{rows}} × {{columns}} 乘以 {{others}} × 3，得到 {{rows}} × 3：每个质点一行，与 Q p = b 一致。',
    small: '{{rows}} × {{columns}} 乘以 {{others}} × 3，得到 {{rows}} × 3：只有固定点所在的行。',
    misfit: '{{rows}} × {{columns}} 乘以 {{others}} × 3，无法相乘：左边有 {{columns}} 列，右边却有 {{others}} 行。',
    result: '乘积，单位 m',
  },
  slip: {
    printed: raw`\begin{aligned} \sympinEnergy = {} & \tfrac{\symw}{2}\operatorname{tr}\bigl(\symp^{\mathrm T}\symC^{\mathrm T}\symC\symp\bigr) \\ & - \symw\operatorname{tr}\bigl(\symp^{\mathrm T}\sympTarget\bigr) \end{aligned}`,
    right: raw`\begin{aligned} \sympinEnergy = {} & \tfrac{\symw}{2}\operatorname{tr}\bigl(\symp^{\mathrm T}\symC^{\mathrm T}\symC\symp\bigr) \\ & - \symw\operatorname{tr}\bigl(\symp^{\mathrm T}\symC^{\mathrm T}\symC\,\sympTarget\bigr) \end{aligned}`,
    why: raw`有一处讲义在静止位置前漏写了 $\symC^{\mathrm T}\symC$。这样一来，罚项会以全部的 $\symw$ 把**每个**质点都拉向静止位置，而在 $\symC^{\mathrm T}\symC$ 为零的地方又没有任何东西与之平衡。（两行都略去了与 $\symp$ 无关的项。）`,
  },
  again: {
    ask: raw`什么时候必须重新分解 $\symQ$：拖动固定点时，还是增加或取消固定点时？`,
    hint: raw`$\sympTarget$ 出现在哪里？`,
    answer: raw`拖动改变的是目标位置，它只出现在右端，所以不必。再固定一个质点会改变 $\symC$，从而改变 $\symQ$，所以必须。在下面拖动试试：无论拖多久，$\symQ$ 的计数都不会变。`,
    caption: '拖动固定点（方块），比较两个计数。',
    q: raw`$\symQ$ 的改变次数`,
    b: raw`$\symb$ 的改变次数`,
  },
  sources: {
    jacobson: 'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Pinned Vertices”一节。',
    levin: 'D. Levin，Mass-Spring Systems on Three Dimensions（课程讲义）：用投影处理固定点。',
    nocedal: 'J. Nocedal、S. Wright，Numerical Optimization：第 15 章，变量消去法；第 17 章，二次罚函数。',
  },
};
