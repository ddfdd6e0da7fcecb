import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  which: raw`
$\symQ$ 的元素 $(i, j)$ 非零只有两种原因：$i = j$，或者 $i$ 与 $j$ 之间有弹簧。每根弹簧在 $(i, i)$ 和 $(j, j)$ 处各加
$\symk$，在 $(i, j)$ 和 $(j, i)$ 处各加 $-\symk$；质量和固定点只加在对角线上。因此 $\symvertexCount^2$ 个元素中，
非零的只有 $\symvertexCount + 2\,\symspringCount$ 个。直接在求解器的矩阵里数一数：
`,
  counts: {
    caption: 'Q 的元素个数',
    scene: '场景',
    all: '全部',
    nonZero: '非零',
    share: '占比',
  },
  list: raw`
**稀疏矩阵**只存这些元素，逐行存放，各带列号。构造的办法是列出**三元组** $(i, j, \text{value})$，次序不限，再把整张表
一次交出去：|Q.setFromTriplets(begin, end)|。同一位置的三元组会**累加**。这正合对弹簧求和之用：每根弹簧写下自己的四个，
不必管之前谁写过。
`,
  triplets: {
    caption: raw`一次插入一个三元组：每根弹簧四个，每个质量、每个固定点各一个。全部插入后，把**累加**改成**覆盖**，再移动滑块。`,
    steps: '已插入的三元组',
    repetition: '同一位置的第二个三元组',
    add: '累加（+=）',
    overwrite: '覆盖（=）',
    none: '还没有存入任何元素。',
    spring: '({{i}}, {{j}}, {{value}} N/m)，来自弹簧 {{index}}',
    mass: '({{i}}, {{j}}, {{value}} N/m)，来自质量 {{index}}',
    pin: '({{i}}, {{j}}, {{value}} N/m)，来自质点 {{index}} 处的固定点',
    matrix: 'Q：{{all}} 个元素中存了 {{stored}} 个',
  },
  report: {
    moved: '用这个矩阵走一个全局步，位置与正确结果最多相差 {{distance}}。',
    failed: '全局步无法进行：在第 {{row}} 行，Cholesky 分解要对 {{pivot}} 开平方。',
  },
  overwriting: raw`
用 |=| 时，对角线上每个位置只留下最后一个三元组：弹簧的那一份在对角线上丢了，在它旁边却还在。弹簧部分的各行之和不再为零，
于是网被推离坐标原点（见箭头），而弹簧本不该知道原点在哪里。弹簧再硬一些，矩阵连正定都不是，$\symL$ 也就不存在了。
`,
  entryByEntry: {
    ask: raw`为什么非要列表？直接对稀疏矩阵写 |Q.coeffRef(i, j) += v| 不行吗？`,
    hint: '元素在内存里一个挨一个，没有空隙。插入新元素时，它后面的那些怎么办？',
    answer: raw`每来一个新元素，后面的就都要后移一位。和是对的（用 |=| 就不对了），但要花多久取决于插入的次序，最坏时随元素个数的平方
增长。程序库可以预留空隙来推迟这件事；列表则不需要：不论次序如何，数一遍、排一次就够了。现场数一数：`,
  },
  insertion: {
    counting: '正在计数……',
    caption: '逐个插入旗帜的 {{triplets}} 个三元组时，元素被移动的次数',
    written: '按弹簧的次序',
    backwards: '倒过来插入',
  },
  slowFlag: {
    ask: '我的矩阵都是稀疏的，旗帜一帧却还要 5 到 10 秒。为什么？',
    hint: raw`打印三元组列表的长度，或者 |Q.nonZeros()|，与上面的表比一比。`,
    answer: raw`值为 0 的三元组也是三元组：它照样被存下来，每次乘法、每次代入都要访问它。对所有 $i$ 和所有 $j$ 写两重循环、
每次都压入一个元素，得到的就是披着稀疏外衣的稠密矩阵。另一条歧路是在稀疏矩阵之间夹了一个稠密矩阵。所以，
三元组要在对**弹簧**的循环里写。下面是旗帜不存零和存下全部零的两种情形；后一种要等一会儿，约占 350 MB 内存，页面不会因此停顿。`,
  },
  flag: {
    start: '给旗帜的一帧计时',
    stop: '停止',
    tooLarge: '求解器拒绝了：这么多零放不进它的内存。',
    caption: '旗帜，朴素算法，50 次迭代',
    precomputation: '预计算',
    step: '一个时间步',
    sparse: '不存零',
    dense: '存下零',
  },
  fillTitle: '填充元',
  fillIn: raw`
分解并不能保住所有的零。消去质点 $i$，就把它余下的相邻质点两两连了起来：这些弹簧本不存在，$\symL$ 却要为它们留出元素，
称为**填充元**。填充元有多少，取决于消去质点的次序。所以求解器先做置换，
$\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}$：只是给质点重新编号，别的都不变。一个简单而有效的规则是：
每次消去余下邻点最少的质点。
`,
  fill: {
    order: '消去次序',
    natural: '按编号',
    minimumDegree: '邻点最少者先',
    Q: '重新编号的 Q：{{all}} 个元素中 {{Q}} 个',
    L: 'L：{{L}} 个元素，其中填充元 {{filled}} 个',
    caption: '61 个质点的网。彩色：填充元。',
  },
  sources: {
    jacobson: 'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Sparse Matrices”一节。',
    davis:
      'T. Davis，Direct Methods for Sparse Linear Systems，2006：第 2 章，三元组与压缩存储；第 7 章，减少填充元的排序。',
    george: 'A. George、J. Liu，The Evolution of the Minimum Degree Ordering Algorithm，SIAM Review 31，1989。',
    eigen: 'Eigen，Sparse matrix manipulations：“Filling a sparse matrix”。',
  },
};
