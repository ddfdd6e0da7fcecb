import type { Catalogue } from '../../../app/messages/index.ts';
import type { en } from './en.ts';

export const zh: Catalogue<typeof en> = {
  heading: '设置',
  methods: {
    label: '方法',
    ccd: 'CCD',
    fabrik: 'FABRIK',
    'least-squares': '阻尼最小二乘',
  },
  arm: {
    heading: '机械臂',
    presets: {
      lab: '实验用机械臂',
      two: '两根等长连杆',
      ten: '十根短连杆',
      hole: '够不到根关节',
    },
    presetHints: {
      lab: '连杆长 0.8、0.4、0.2、1.2 m',
      two: '两根连杆，各长 1.3 m',
      ten: '十根连杆，各长 0.26 m',
      hole: '连杆长 0.3、2、0.5 m：末端执行器与根关节至少相距 1.2 m',
    },
    rootHeight: '根关节高度',
  },
  links: {
    link: '关节',
    length: '长度',
    bend: '最大弯角',
    between: '{{from}} – {{to}}',
    lengthOf: '关节 {{from}} 到关节 {{to}} 的连杆长度',
    bendOf: '关节 {{joint}} 的最大弯角',
    bendHint: '弯角是连杆与前一根连杆方向之间的夹角；在根关节处，则是与竖直向下方向的夹角。留空表示不限。',
    remove: '移除关节 {{from}} 到关节 {{to}} 的连杆',
    add: '添加连杆',
  },
  search: {
    heading: '搜索',
    iterations: '最大迭代次数',
    epsilon: '容差',
    reset: '恢复默认值',
    turn: '每个目标点的最大转角',
    turnHint: '各关节相对搜索起点最多转动的角度。留空表示不限。',
    precision: '精度',
    double: '双精度',
    single: '单精度',
    precisionHint: '单精度由余弦求角，约 5·10⁻⁴ 弧度以下的角会丢失；双精度用 atan2 求角，则不会。',
  },
};
