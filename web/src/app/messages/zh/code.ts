import type { code as en } from '../en/code.ts';
import type { Catalogue } from '../index.ts';

export const code: Catalogue<typeof en> = {
  listing: '{{file}} 的源代码（逐行）',
  line: '第 {{number}} 行：{{line}}',
  fold: '对应的代码',
  plain: '这是便于阅读的写法；快速实现得到相同的迭代结果。',
};
