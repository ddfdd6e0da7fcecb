import type { Catalogue } from '../../../app/messages/index.ts';
import type { en } from './en.ts';

export const zh: Catalogue<typeof en> = {
  heading: '公式',
  none: '–',
  root: '关节 {{joint}}（根关节）',
  joint: '关节 {{joint}}',
  effector: '关节 {{joint}}（末端执行器）',
  errorChange: '误差 {{before}} → {{after}}',
  forward: {
    heading: '正向运动学',
    table: '各关节的位置、连杆长度和转角',
    oneJoint: '关节 {{joint}} 的正向运动学，单位：米',
    length: '长度',
    rotation: '= 绕 {{axis}} 转 {{angle}}',
    noRotation: '不转动',
    matrix: '的矩阵形式',
    matrixOf: '关节 {{joint}} 相对世界坐标系的旋转矩阵，3 × 3',
  },
  method: {
    ccd: '循环坐标下降（CCD）',
    fabrik: 'FABRIK（前后向到达法）',
    'least-squares': '阻尼最小二乘',
  },
  ccd: {
    rot: 'rot(θ, a) 表示绕轴 a 转 θ 角的旋转；R 的转置把转轴变换到关节自身的坐标系。',
    axis: '绕 {{axis}}',
    table: '从关节 {{joint}} 出发的两个向量，单位：米',
    held: '实际转过 {{angle}}：关节限位不允许再转。',
    rounded: '实际转过 {{angle}}：单精度由余弦求角，而小角的余弦会舍入为 1。',
  },
  fabrik: {
    backward: '后向过程',
    forward: '前向过程',
    rotations: '由位置求旋转',
    limit: '退回到限位之内',
    moved: '移动/{{unit}}',
    turned: '转角',
    rootGap: '根关节偏离原位 {{length}}；前向过程会把它放回去。',
  },
  leastSquares: {
    axes: 'x̂、ŷ、ẑ 是世界坐标系的坐标轴；JΔ 是转动微小时末端执行器的位移。',
    table: '误差向量、线性模型预测的位移和实际位移',
    damping: '= {{lambda}}；其平方是误差平方的 {{share}}',
    unknownDamping: '无法由转动推出：转动受到了限位，误差未能减小，或者阻尼过小。',
    turns: '各关节的转动，单位：度',
    matrix: '3 × {{columns}}，单位：米',
    matrixLabel: '雅可比矩阵，每个关节对应三列，单位：米',
  },
  notes: {
    start: '尚未转动：搜索从这个姿态开始。',
    limit:
      '这些位置所要求的转角超出了关节限位。因此从根关节开始，每个关节从自己的实际位置把连杆指向下一关节本应到达的位置，转到限位所允许的程度为止。',
    within: '没有关节超出限位，姿态保持不变。',
    straight: '没有任何姿态能到达目标点，因此无需搜索：机械臂被沿根关节到目标点的直线摆直，这是离目标点最近的姿态。',
    straightened:
      '没有任何姿态能到达目标点，因此无需搜索：各关节都向沿根关节到目标点的直线伸直的姿态转动，转角不超过限制。',
    bend: '机械臂与目标点共线，此时任何方法求出的转角不是零就是 180°，所以先让每个关节稍稍弯曲。',
  },
  outcomes: {
    converged: '已收敛：末端执行器与目标点的距离不超过 ε。',
    held: '受限位约束：没有关节能再向目标点转动。',
    slowed: '受转角限制：对这一个目标点，各关节已转到允许的最大角度。',
    stalled: '停滞：虽然目标点可以到达，但各关节都不再移动。',
    rounded: '停滞：单精度把剩余的小转角舍入为零，各关节都不再移动。',
    tooFar: '无法到达：目标点距根关节 {{distance}}，而机械臂全长只有 {{farthest}}。',
    tooNear: '无法到达：目标点距根关节 {{distance}}，而最长的连杆使末端执行器与根关节至少相距 {{nearest}}。',
    notYet: '{{iterations}} 次迭代已全部用完，误差仍大于 ε。',
  },
  result: {
    heading: '搜索结果',
    error: '误差',
    iterations: '迭代 {{made}} 次，上限 {{most}} 次',
  },
  errors: {
    heading: '逐次迭代的误差',
    curve: '距离',
    tolerance: '容差 ε',
    iteration: '迭代次数',
    label: '末端执行器到目标点的距离，mm',
    summary: '末端执行器到目标点的距离：经 {{iterations}} 次迭代，从 {{before}} 减小到 {{after}}',
  },
};
