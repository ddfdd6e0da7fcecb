import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  action: raw`
每个全局步都要求出满足下式的位置：

$$\symQ\symp = \symb$$

纸面上常写成 $\symp = \symQ^{-1}\symb$。请把它读作**一种作用，而不是一个矩阵**：找出被 $\symQ$ 变成 $\symb$ 的那个量。
$\symQ^{-1}$ 里的数，谁也不必看到。

如果 $\symQ$ 是两个三角矩阵之积，这种作用就很容易实现。每个质量、每根弹簧、每个固定点都给能量添上一个平方项，
所以 $\symQ$ 对称正定，于是存在下三角矩阵 $\symL$，即 **Cholesky 因子**，使得

$$\symQ = \symL\symL^{\mathrm T}$$

一个难解的方程组就化为两个逐行可解的方程组：

$$\symL x = \symb \qquad \symL^{\mathrm T}\symp = x$$

$\symL x = \symb$ 的第一行只有一个元素，做一次除法便得 $x_0$；第二行于是只剩一个未知数，如此逐行向下，称为**前代**。
另一个方程组从最后一行向上解，称为**回代**。
`,
  substitution: {
    caption: raw`逐步走完前代与回代。数值取自图中的网，只看高度，即 $\symb$ 和 $\symp$ 的中间一列。然后拖动质点、移动滑块：
什么会改变 $\symL$？`,
    steps: '已解的行',
    start: '左表的第一行只有一个非零元素。',
    forwards: '向下：前代',
    backwards: '向上：回代',
    residual: '求解完成：Q p 的每一行与 b 相差不超过 {{residual}} N。',
    counted:
      '打开本页以来，为这两张表分解了 {{factorised}} 次（Q 每变一次），求解了 {{solved}} 次（Q 或 b 每变一次）。',
  },
  precompute: raw`
拖动改变 $\symb$，$x$ 与 $\symp$ 随之改变，$\symL$ 却不变。只有 $\symQ$ 变时它才变：也就是 $\symk$、$\symdeltaT$、$\symw$、
某个质量、某根弹簧，或者固定点的集合变了。

所以求解器分成两个函数：**预计算**只分解一次；**求解**在每个时间步的每次迭代中代入。每步 50 次迭代、每秒 30 步，
就是一次分解供每秒 1500 次求解使用。
`,
  refactorise: {
    ask: '我把分解写在迭代循环里面，画面是对的。这样做对吗？',
    hint: raw`
看看

$$\symQ = \symk\symA^{\mathrm T}\symA + \symM/\symdeltaT^2 + \symw\symC^{\mathrm T}\symC$$

里有哪些字母，循环中哪些会变？
`,
    answer: raw`位置是对的，功夫却白费了：$\symp$、$\symd$、$\symb$ 都不在 $\symQ$ 里，每次分解得到的都是早已有的 $\symL$。
代价多大，让时钟来说：`,
  },
  refactorising: {
    start: '两种都计时',
    running: '正在计时……',
    caption: '一个时间步的全部求解：{{iterations}} 次迭代，n = {{n}} 个质点',
    once: '事先分解',
    everyTime: '每次都分解',
    ratio: '倍数',
    dense: '稠密',
    sparse: '稀疏',
  },
  costTitle: '要花多少时间',
  cost: raw`
设有 $n$ 个质点，数一数加法和乘法。稠密分解是三重循环，约 $\tfrac13 n^3$ 次；求逆约 $2n^3$ 次。代入时三角矩阵的每个元素只用一次：
各做一次加法和乘法，对 $\symb$ 的一列，前代加回代共 $2n^2$ 次。

但 $\symQ$ 的元素大多是零。如果只存非零元素，又按好的次序消去质点，那么平面网的分解约需 $n^{1.5}$，
每次求解只比 $n$ 略多。

不必相信，测一测便知。按下按钮，五种运算就在你的机器上从 25 个质点的方形网测起，页面照常可用。
`,
  timing: {
    start: '开始计时',
    again: '重新测量',
    stop: '停止',
    progress: '已测的网',
    finished: '测量完毕',
    plot: '各种运算的时间与 n 的关系，两轴均为对数。下面的表格给出同样的数值。',
    axes: { n: 'n，质点数', time: '一次运算的时间，ms' },
    exponents: '时间随 n 的增长',
    call: '运算',
    theory: '理论',
    measured: '本机',
    points: '{{points}} 个点',
    caption:
      '共十张网，每张的质点数约为前一张的两倍。线：最小二乘拟合的 n 的幂。某种运算一旦超过四分之一秒，就不再用于更大的网。',
    calls: {
      dense_inverse: '稠密求逆',
      dense_factorise: '稠密分解',
      dense_substitute: '稠密求解',
      sparse_factorise: '稀疏分解',
      sparse_substitute: '稀疏求解',
    },
  },
  reading: raw`
你测得的指数会接近理论值，但不会相等，每次也略有不同。网很小时，调用本身比算术还费时，所以各条线起初都是平的，
拟合只取最大的四张网。矩阵大到放不进处理器的高速缓存时，曲线会陡上一段。浏览器的时钟走得很粗，
所以很短的运算要重复到满 20 ms 才计时。此外，别的程序也在占用处理器。
`,
  whyNotInverse: {
    ask: raw`为什么不先把 $\symQ^{-1}$ 算出来，以后每次迭代只做乘法？`,
    hint: '推一下网上的一个质点，还有哪些质点会动？',
    answer: raw`$\symQ^{-1}$ 的第 $j$ 列表示：用一牛顿的力推质点 $j$ 时，每个质点各移到哪里。网是连在一起的，
所有质点或多或少都会动，所以没有一个元素是零。做乘法要读 $n^2$ 个数，求出这些数又约等于六次稠密分解。
三角因子则保住了大部分的零。以 61 个质点的网为例，现场数一数：`,
  },
  inverse: {
    Q: 'Q：{{all}} 个元素中 {{count}} 个非零',
    L: 'L：{{all}} 个中 {{count}} 个',
    inverse: 'Q⁻¹：{{all}} 个中 {{count}} 个',
  },
  sources: {
    jacobson:
      'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Matrices”一节，把求解看作逆矩阵的作用。',
    liu: 'T. Liu、A. Bargteil、J. O’Brien、L. Kavan，Fast Simulation of Mass-Spring Systems，2013：第 4 节，可以事先分解的矩阵。',
    golub: 'G. Golub、C. Van Loan，Matrix Computations（第 4 版）：3.1 节，三角方程组；4.2 节，正定方程组。',
    george: raw`A. George，Nested Dissection of a Regular Finite Element Mesh，SIAM Journal on Numerical Analysis 10，1973：$n^{1.5}$ 与 $n\log n$。`,
    davis: 'T. Davis，Direct Methods for Sparse Linear Systems，2006：第 3、4 章。',
  },
};
