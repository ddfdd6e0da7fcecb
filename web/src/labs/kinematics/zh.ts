import type { en } from './en.ts';

export const zh: typeof en = {
  title: '逆向运动学',
  intro:
    '一条由关节和连杆组成的机械臂，它的末端叫作末端执行器。正向运动学回答：各关节转动之后，末端执行器在哪里；逆向运动学反过来问：要让它到达这里，各关节该怎样转？',
  opening: '正在准备机械臂……',
};
