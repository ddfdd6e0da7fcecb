import type { Catalogue } from '../../../app/messages/index.ts';
import type { en } from './en.ts';

const { raw } = String;

export const zh: Catalogue<typeof en> = {
  intro: raw`
学生真正会犯的十个错误。每个错误都由一个单独的求解器来犯，它与正确的求解器并排运行：同一场景、同一初始状态、同一时钟。**先观察，再猜原因，然后往下读。**`,
  modes: { label: '做什么', cabinet: '看十个错误', quiz: '猜错误' },
  choose: '错误',
  known: '已在测验中认出',
  stage: {
    right: '正确',
    wrong: '带有错误',
    net: '网 {{net}}',
    movePins: '上下移动固定点',
    scene: '场景',
    best: '最能看清的：{{scene}}',
    lab: '实验室当前的：{{scene}}',
    hides: '在这个场景里，这个错误几乎看不出来；换成另一个就能看清。',
    tooLarge: '实验室当前的场景超过 {{limit}} 个质点：对其中较慢的几个错误来说太大了。',
  },
  failure: {
    nonFinite:
      '已停止：质点 {{vertex}} 的坐标在第 {{step}} 个时间步的半步“{{half}}({{iteration}})”中不再是有限数（{{value}}）。图中是此前的位置。',
    tooFar:
      '已停止：质点 {{vertex}} 在第 {{step}} 个时间步的半步“{{half}}({{iteration}})”中飞出了允许的范围（{{value}} m）。图中是此前的位置。',
    other: '已在第 {{step}} 个时间步停止：{{sentence}}。',
  },
  measures: {
    label: '曲线显示什么',
    x: '时间步',
    height: '最低质点的高度，单位 m',
    energy: '动能、弹簧势能与重力势能之和，单位 J',
    time: '每个时间步的用时，单位 ms',
    names: { height: '高度', energy: '能量', time: '用时' },
    summary: {
      height: '正确的网与带有错误的网：最低质点的高度随时间步的变化。',
      energy: '正确的网与带有错误的网：能量随时间步的变化。',
      time: '正确的网与带有错误的网：每个时间步的用时。',
    },
  },
  counts: {
    caption: '代价',
    time: '一个时间步，单位 ms',
    factorising: '分解总共用时，单位 ms',
    factorisations: '至今的分解次数',
    stored: 'Q 存储的元素个数',
  },
  parts: {
    symptom: '看到的现象',
    why: '原因',
    formula: '公式中的位置',
    code: '代码中的位置',
    fix: '改法',
    wrong: '错误',
    right: '正确',
    marked: '两者不同的行已标出。',
    section: '课程中的相关章节：',
  },
  cards: {
    'd-once': {
      title: raw`循环里没有更新 $\symd$`,
      symptom: raw`单摆不摆动，只是缓慢地往下爬，然后停住，像泡在蜂蜜里一样。`,
      why: raw`局部步写在了循环之前。于是 $\symd$ 一直保持 $\sympCurr$ 的方向，之后的每次迭代都在重复求解同一个 $\symQ\symp = \symb$，**五十次迭代得到的位置与一次迭代完全相同**，每一位都一样。每根弹簧都想保持一个时间步之前的方向，因此任何转动都受到阻碍。`,
      fix: raw`把局部步放到循环**里面**：$\symd$ 由迭代点 $\symp$ 算出，而不是由 $\sympCurr$ 算出。`,
    },
    'k-forgotten': {
      title: raw`$\symb$ 中漏了 $\symk$`,
      symptom: raw`弹簧缩短了。单根 1 m 的弹簧最后只有 11 cm；网在固定点之间绷得紧紧的，只下垂 0.19 m，而不是 0.88 m。`,
      why: raw`$\symQ$ 里有 $\symk\symA^{\mathrm T}\symA$，$\symb$ 里却只有 $\symA^{\mathrm T}\symd$。弹簧的刚度是对的，目标却成了 $\symd/\symk$，好像原长是 $\symr/\symk$：当 $\symk = 100$ N/m 时是 1 cm，而不是 1 m。**若 $\symk = 1$ N/m，则一切正常**，所以最初的测试发现不了。`,
      fix: raw`$\symk$ 要出现两次：在 $\symQ$ 中，也在 $\symb$ 中。`,
    },
    'sign-in-A': {
      title: raw`$\symA$ 少了负号`,
      symptom: raw`三个时间步之内网就乱成一团，有的弹簧是正常最大长度的三倍，并且凭空多出 8000 J 以上的能量。`,
      why: raw`两端都写 $+1$ 时，$\symA\symp$ 的一行是 $\symp_i + \symp_j$，而不是 $\symp_i - \symp_j$。这不是长度，它取决于网摆放在哪里，并把相邻质点拉向原点的两侧。$\symQ$ 由同一个 $\symA$ 构成，仍然对称正定，所以**分解时不会报错**。`,
      fix: raw`$i$ 处写 $+1$，$j$ 处写 $-1$。检验方法：$\symA\mathbf 1 = 0$，因为整体平移不会拉伸任何弹簧。`,
    },
    'times-swapped': {
      title: raw`$\sympCurr$ 与 $\sympPrev$ 写反了`,
      symptom: raw`网在抖动：每过一个时间步就反向运动，幅度大约加倍。三十个时间步左右之后，它已在一百万米之外。`,
      why: raw`自由运动的质点应当到达 $2\sympCurr - \sympPrev$，这里却到达 $2\sympPrev - \sympCurr$：每个时间步速度都反向并加倍（$\lambda^2 + \lambda - 2 = 0$ 的解是 $1$ 和 $-2$）。相对时间步来说足够硬的弹簧能顶住它：**在“塔架”场景里什么也看不出来**。`,
      fix: raw`$\sympCurr$ 是现在，$\sympPrev$ 是之前：$2\sympCurr - \sympPrev$ 指向前方。时间步结束时，先 $\sympPrev \leftarrow \sympCurr$，再 $\sympCurr \leftarrow \symp$。`,
    },
    'rest-for-targets': {
      title: raw`目标位置写成了 $\symC^{\mathrm T}\symC\,\symV$`,
      symptom: raw`在移动固定点之前一切正常。移动之后，它仍停在场景原来的位置。可以拖动一个固定点，也可以让页面来移动它们。`,
      why: raw`$\symC^{\mathrm T}\symC$（#V × #V）从**每个**质点各占一行的数组中保留固定点所在的行；$\symC^{\mathrm T}$（#V × #pinned）则要求**每个固定点**占一行。写 $\symC^{\mathrm T}\symC$ 就需要前一种数组，于是随手用了静止位置 $\symV$。这样能通过编译，而且只要固定点都在静止位置就是对的。拖动只改变目标位置，而目标位置根本没有出现。`,
      fix: raw`用 $\symw\symC^{\mathrm T}$ 乘以目标位置（每个固定点一行）；或者用 $\symw\symC^{\mathrm T}\symC$ 乘以所有质点的数组，其中固定点的行**就是**目标位置。`,
    },
    'pins-after-solving': {
      title: raw`求解之后才把固定点放回去`,
      symptom: raw`固定点都在该在的地方，但与它们相连的弹簧撑不住：网静止悬挂时，它们伸长 76 %，而不是 29 %，网也垂得更深。`,
      why: raw`$\symQ$ 和 $\symb$ 都不知道有固定点。全局步让固定点像其他质点一样自由移动，并按**这样的**位置算出相邻质点，之后才把固定点的行覆盖掉。结果不满足任何方程组，下一次迭代又从头重演。`,
      fix: raw`固定点要写进方程组：$\symw\symC^{\mathrm T}\symC$ 加进 $\symQ$，$\symw\symC^{\mathrm T}\symC\,\sympTarget$ 加进 $\symb$；或者像本页的快速实现那样，把它们的行和列从方程组中消去。`,
    },
    'factorised-again': {
      title: raw`每次迭代都重新分解 $\symQ$`,
      symptom: raw`画面每一位都正确，只有时钟看得出问题：每个时间步的大部分时间花在分解上，一共 50 次。`,
      why: raw`$\symQ$ 与 $\symp$、$\symd$ 无关，也与时间、外力和固定点被拖到哪里无关，所以每次得到的都是同一个 $\symL$。**分解比随后的回代贵得多**，网越大差距越大。`,
      fix: raw`在第一个时间步之前分解一次；只有当 $\symk$、$\symm$、$\symdeltaT$、$\symw$、弹簧或固定点的**集合**改变时才重新分解。`,
    },
    'gradient-as-force': {
      title: raw`把梯度当作力`,
      symptom: raw`网向上坠落，与正确的网互为镜像。风会逆着自己吹，鼠标本想拉近，却会推远。`,
      why: raw`力指向能量下降的方向：$\symf = -\nabla E$。外力势能是 $-\sum_i \symp_i^{\mathrm T}\symfExt_i$，它的梯度是 $-\symfExt$。对它求导并把结果加进 $\symb$，力的符号就反了。`,
      fix: raw`$\symb$ 中应当是力 $\symfExt$ 本身：令梯度为零后，除 $\symQ\symp$ 之外的各项都移到了等号另一边，符号也随之改变。`,
    },
    'stored-zeros': {
      title: raw`三元组里有零`,
      symptom: raw`画面正确，但是很慢。对塔架来说，$\symQ$ 存储 43,681 个元素，而不是 1,745 个；$\symL$ 存储 21,945 个，而不是 3,183 个。换成旗帜就是 1100 万个。`,
      why: raw`对所有质点对循环，没有弹簧的地方也加进了三元组。稀疏矩阵给什么就存什么，数 0 也照存；而分解只看**存了**什么。在它看来人人都相邻，任何消元顺序都不再有用。`,
      fix: raw`只为确实存在的东西建立三元组：每根弹簧四个，每个质量一个，每个固定点一个。`,
    },
    'one-iteration': {
      title: raw`只迭代一次，看上去像有阻尼`,
      symptom: raw`单摆缓慢地爬到静止。它最多能失去 10.3 J，迭代一次在第一秒内就失去 9.4 J；迭代五十次失去 4.4 J，并且能摆动。`,
      why: raw`只迭代一次时，弹簧的目标还是 $\sympCurr$ 的方向，因此任何转动都受到阻碍。这看上去像摩擦，可是公式里没有摩擦：这是**求解器停得太早的误差**。（五十次也会失去一些能量，那是隐式欧拉法本身的阻尼。）`,
      fix: raw`多迭代几次，或者换用所需次数更少的方法：[“收敛”视图](springs/convergence)对它们作了比较。`,
    },
  },
  quiz: {
    intro: '观察它们的运动，拖动固定点，查看曲线和代价；有些错误只在那里才看得出来。',
    ask: '这两个求解器中有一个犯了错误。是哪一个错误？',
    picture: '两张网 A 和 B，其中一张是正确的',
    label: '你的回答',
    rightAnswer: '答对了。',
    wrongAnswer: '还不对。',
    truth: '网 {{net}} 中的错误：',
    next: '下一题',
    score: '答对 {{right}} 题，共 {{asked}} 题。已认出 {{known}} 个错误，共 10 个。',
    noScore: '还没有回答过。',
    forget: '重新开始',
    kept: '成绩保存在这个浏览器里。',
    read: '到陈列中查看',
  },
};
