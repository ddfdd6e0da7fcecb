import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`
    [上一节](optimisation)把一个时间步化成了最小化问题：在所有位置 $\symp$ 中，求使 $\symobjective$ 最小者。
    其中几乎各项都很简单，不过是 $\symp$ 的常数、一次式和二次式；唯一的例外，是弹簧势能里的长度
    $\lVert \symp_i - \symp_j \rVert$。正是其中的根号使问题成为非线性的。

    这里的思路不是消去长度，而是把它交给一个辅助变量。给每根弹簧配一个向量 $\symd_{ij}$，长度规定为
    $\symr_{ij}$，方向任意。在这些向量中，有一个离弹簧最近，而它与弹簧的距离恰好就是伸长量：

    $$\begin{aligned} &\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2 \\ &\qquad = \min_{\lVert \symd_{ij} \rVert = \symr_{ij}} \lVert (\symp_i - \symp_j) - \symd_{ij} \rVert^2 \end{aligned}$$

    [第 2 节](energy)画出了它的几何意义。把求最小提到最前面，时间步要找的就**既有**位置，**也有**辅助变量：

    $$\begin{aligned} \symobjective &= \min_{\symd} \symsurrogate \\ \symsurrogate &= \sum_{ij} \tfrac12 \symk \lVert (\symp_i - \symp_j) - \symd_{ij} \rVert^2 + \dots \end{aligned}$$

    省略号代表惯性、外力和固定点各项，与前面相同。未知量变多了，要做的事却变少了：固定其中一组，求另一组都很容易。
  `,
  halves: {
    title: '两个容易的半步',
    text: raw`
      **局部步。**固定 $\symp$。每根弹簧的 $\symd_{ij}$ 只出现在它自己的那一项里，所以各根弹簧可以分别求解，一个公式就够了：

      $$\symd_{ij} = \symr_{ij}\,\frac{\symp_i - \symp_j}{\lVert \symp_i - \symp_j \rVert}$$

      **全局步。**固定 $\symd$。此时 $\symsurrogate$ 是 $\symp$ 的二次函数，在导数为零处取最小值，
      也就是求解一个线性方程组，而且系数矩阵始终不变：

      $$\symQ\symp = \symb, \qquad \symb = \symk\symA^{\mathrm T}\symd + \symy$$

      然后用新的 $\symp$ 再做局部步，如此交替。局部步和全局步各一次，称为一次**迭代**，也叫一轮。两个半步都不会使 $\symsurrogate$ 增大：它们各自在允许的范围内取最优，
      而“保持不动”总在允许之列。局部步刚做完时 $\symsurrogate = \symobjective$。因此每一轮之后
      $\symobjective$ 都会下降，除非已经到达极小点。
    `,
    caption: raw`请逐半步前进。“每根弹簧各自”一图是局部步：每根弹簧沿当前方向取原长，整张网被撕开。“所有弹簧一起”一图是全局步：一次求解又把它缝合起来，箭头表示各质点的移动。也可以拉动一个质点，再继续前进。`,
  },
  loops: {
    ask: raw`全局步之后又回到局部步。这时，时间前进了吗？`,
    hint: raw`这里有两层循环，一层套着另一层。哪些量的记号里带有 $t$？`,
    answer: raw`
      没有。外层循环是时间：每转一圈，求出一个新的 $\symp$。内层循环只是不断改进对它的猜测。
      时间步开始时的已知量 $\sympCurr$、$\sympPrev$，以及由它们得到的 $\symy$，在内层循环中保持不变。
      局部步更新 $\symd$，$\symb$ 随之更新；全局步更新 $\symp$。只有到了“接受”，$\symp$ 才成为下一步的 $\sympCurr$。

      请逐半步前进，看看哪几行在变：
    `,
    caption: raw`所选弹簧与质点的数值。竖条标出这半步改变了的量。`,
    changed: '已改变',
  },
  peanut: {
    ask: raw`程序里每个公式都对，网却像陷在花生酱里一样缓缓下沉。是什么太小了？`,
    hint: raw`一轮局部与全局，能让一个质点走多远？`,
    answer: raw`
      是迭代次数 $K$。每个时间步都从 $\sympCurr$ 出发开始搜索，而每个全局步所趋向的弹簧，仍指着原来的方向。
      轮数太少，就只走完一部分路程；没有走完的部分就像阻力一样，而且 $\symk$ 越大越明显。

      如果只在内层循环之前算一次 $\symd$，而不是在循环中更新，也会如此：第二轮求解的还是第一轮的方程组，
      得到的还是第一轮的解，做五十轮与做一轮没有区别。
    `,
    height: raw`质点 7 的高度，m`,
    time: raw`时间，s`,
    rounds: 'K = {{iterations}}',
    summary: 'K = 1 时，网片最低的质点缓缓下沉；轮数增多后，它迅速落下、来回摆动，最后静止。',
  },
  stop: {
    title: '何时停止',
    text: raw`
      要精确到达极小点，需要无穷多轮，实际上也没有必要。常用的停止准则有三种。

      - 做完**固定的轮数**。每一帧的开销事先已知，精度却不得而知。
      - **梯度**足够小。它的最大分量就是最差的质点上尚未平衡的力，单位是牛顿；若为零，则 $f = ma$ 严格成立。
      - 一轮使 $\symobjective$ **下降得很少**。这最容易检查，但走得慢并不等于已经走到。

      课程采用第一种，取五十轮。实验室里可以看到[每种准则使每种方法停在哪里](springs/convergence)。
    `,
    caption: raw`图中是这一个时间步。选一种准则，看它在第几轮之后结束。`,
    curve: '最差的质点',
    rounds: '轮数',
    force: raw`$\symgradient$ 的最大分量，N`,
    summary: '在对数刻度上，不平衡的力随轮数近似沿直线下降。',
    tolerance: raw`$\varepsilon$ 的取值：梯度为 {{gradient}}，下降量为 {{decrease}}。`,
  },
  enough: {
    ask: raw`对这块网片，多少轮才够？如果弹簧的刚度变为四倍呢？`,
    hint: raw`曲线近似是一条直线，而纵轴是对数刻度。这说明相邻两轮之间有什么关系？`,
    answer: raw`
      每一轮之后，差距大约都缩小为原来的同一个比例。这个比例取决于 $\symkappa$，它衡量一个时间步内弹簧与惯性孰强孰弱：
      弹簧越硬、$\symdeltaT$ 越长、质点越轻，比例就越接近 1。所以没有一个轮数永远够用。
      不过轮数的增长慢于 $\symkappa$ 本身：刚度变为四倍，轮数大约只变为两倍到两倍半。
      下图是使所有质点的不平衡力都不超过 {{tolerance}} 所需的轮数：
    `,
    kappa: raw`刚度数 $\symkappa$`,
    rounds: '所需轮数',
    series: '网片，第 8 个时间步',
    summary: '所需轮数随刚度数增加，但增长得比刚度数慢。',
  },
  sources: {
    jacobson:
      'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Time integration as energy optimization”一节，辅助变量 d、两个半步、五十次迭代。',
    liu: 'T. Liu、A. Bargteil、J. O’Brien、L. Kavan，Fast Simulation of Mass-Spring Systems，2013：方法本身，以及它与牛顿法的收敛对比。',
    nocedal: 'J. Nocedal、S. Wright，Numerical Optimization：9.3 节，对各组变量轮流求最小。',
  },
};
