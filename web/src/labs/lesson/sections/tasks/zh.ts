import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`
整个模拟由七个函数组成。如果你在修这门课，就要自己动手编写；这里列出每个函数的输入、输出以及它对应的公式。每个函数下面附有求解器自己的版本，本页面正是由这些文件编译而来的。**先自己写，再作比较。**

把指针移到代码中的符号上，公式和图中的同一事物就会亮起；选中一根弹簧，代码中与它有关的符号也会亮起。`,
  caption: '这些函数的处理对象。逐步执行一个时间步，并在下面的代码中对照。',
  open: '显示求解器的版本',
  tasks: {
    lengths: {
      title: 'edge_lengths',
      text: raw`输入：位置 $\symV$（#V × 3）和弹簧 $\symE$（#E × 2）。输出：$\symr$，共 #E 个数，单位为米。只用静止位置调用一次。`,
    },
    incidence: {
      title: 'signed_incidence_matrix_dense',
      text: raw`输入：#V 和 $\symE$。输出：$\symA$（#E × #V），每行只有一个 $+1$ 和一个 $-1$，其余为零。不过是对弹簧的一个循环。`,
    },
    precomputation: {
      title: 'fast_mass_springs_precomputation_dense',
      text: raw`输入：静止位置、弹簧、质量、固定点、$\symk$、$\symdeltaT$、$\symw$。输出：$\symr$、$\symA$、$\symM$、$\symC$ 以及 $\symQ$ 的分解。凡是不随时间步改变的量都在这里计算。`,
    },
    step: {
      title: 'fast_mass_springs_step_dense',
      text: raw`输入：预计算的结果，以及 $\sympCurr$、$\sympPrev$ 和 $\symfExt$。输出：新的位置 $\symp$。先计算一次 $\symy$，然后局部步与全局步交替执行，直到次数足够。`,
    },
    sparseIncidence: {
      title: 'signed_incidence_matrix_sparse',
      text: raw`还是同一个 $\symA$，只是不存零。三元组与前面完全相同，不同的只是由它们生成的矩阵。`,
    },
    sparsePrecomputation: {
      title: 'fast_mass_springs_precomputation_sparse',
      text: raw`与前面相同，但中途不允许出现存有零元的矩阵：既不能用稠密矩阵相乘，也不能有值为零的三元组。$\symQ$ 由每根弹簧、每个质量和每个固定点的贡献累加而成。`,
    },
    sparseStep: {
      title: 'fast_mass_springs_step_sparse',
      text: raw`与稠密版本一字不差。只要前六个函数正确，这里就没有别的事可做。`,
    },
  },
  mistakes: {
    damped: {
      ask: raw`你的网像泡在蜂蜜里一样，本该摆动的弹簧只会缓慢爬行。应该检查时间步里的哪一行？`,
      hint: raw`一个时间步迭代 50 次，其中 $\symd$ 计算了几次？`,
      answer: raw`多半是局部步写在了循环之前，而不是循环之内。这样 $\symd$ 始终保持 $\sympCurr$ 的方向，第一次之后的所有迭代都在重复求解同一个方程组，效果与只迭代**一次**相同。可在下面比较：同一场景分别迭代 1 次和 50 次。`,
      caption: '把 K 设为 1 并播放，然后改为 50。',
    },
    k: {
      ask: raw`只要 $\symk$ 不等于 1，你的网就缩成一团或者飞散。漏了什么？`,
      hint: raw`$\symk$ 出现在 $\symQ$ 中。还应该出现在哪里？`,
      answer: raw`还应出现在 $\symb = \symk\symA^{\mathrm T}\symd + \symy$ 中。漏掉它，矩阵按刚度 $\symk$ 的弹簧计算，右端却按刚度 1 计算，两边折中得到的长度大约只有应有长度的 $1/\symk$。`,
    },
    order: {
      ask: raw`最初几步看上去没有问题，随后你的网却像失去惯性一样缓慢爬行；而你同学的网上下乱跳，一次比一次跳得远。你和同学分别可能把什么弄反了？`,
      hint: raw`$\sympCurr - \sympPrev$ 除以 $\symdeltaT$ 是什么？`,
      answer: raw`$\sympCurr - \sympPrev$ 给出速度。你**先**把 $\symp$ 赋给了 $\sympCurr$，之后才把 $\sympCurr$ 赋给 $\sympPrev$：二者变得相同，每个时间步都从静止开始。同学则把 $2\sympCurr - \sympPrev$ 中的两项写反了：速度的符号相反，惯性把一切抛回来处并且越过它，每一步的距离大约加倍。下图把同学的网与正确的网放在一起。`,
    },
    slow: {
      ask: raw`旗帜要五秒才能算出一帧，而你的函数都是对的。怎么办？`,
      hint: raw`数一数三元组的个数，再数一数分解的次数。`,
      answer: raw`常见原因有两个：一是存入了值为零的三元组（对所有质点对循环，没有弹簧的地方也加 $0$，就会产生 $3321^2$ 个三元组）；二是每个时间步甚至每次迭代都重新分解。前者见[第 8 节](sparse)，后者见[第 7 节](solving)。另外编译时要打开优化选项，否则 Eigen 会慢几十倍。`,
    },
  },
  nets: {
    captions: {
      k: '同一个三角形算两遍，k = 100 N/m，第二个在 b 中漏了 k。播放，并读出它的弹簧有多长。',
      order: '播放，或逐步前进：最初几步就能看出差别。然后从头再来，观察它怎样跳动。',
      slow: '同一座塔算三遍，三者的位置完全相同。逐步前进，比较每个时间步所用的时间。',
    },
    names: {
      none: '正确',
      'k-forgotten': 'b 中漏了 k',
      'times-swapped': '两项写反',
      'stored-zeros': 'Q 中存了零',
      'factorised-again': '每次迭代都分解',
    },
    length: '弹簧长度为原长的 {{percent}}%',
    kinetic: '动能 {{energy}}',
    failed: '已停止：在第 {{step}} 个时间步飞得太远',
    cost: '每个时间步 {{time}}，至今分解 {{count}} 次',
  },
  cabinet: '十个常见错误：逐个与正确的求解器并排观察，另有测验',
  sources: {
    jacobson: 'A. Jacobson，Computer Graphics – Mass-Spring Systems（课程讲义）：“Tasks”一节；函数名沿用该课程。',
    own: '代码由本项目根据公式自行编写（MIT 许可证），位于 wasm/core 文件夹。',
  },
};
