import { afterEach, expect, test, vi } from 'vitest';
import { language } from '../../../../../web/src/app/messages/index.ts';
import { momentAt } from '../../../../../web/src/labs/kinematics/trace/moment.ts';
import { momentText } from '../../../../../web/src/labs/kinematics/trace/moment_text.ts';
import { armSearch } from '../../../../support/arm_search.ts';

vi.stubGlobal('document', { documentElement: {} });
afterEach(() => {
  language.value = 'en';
});

const textAt = (search: ReturnType<typeof armSearch>, event: number) => momentText(search, momentAt(search, event));

test('a moment says which iteration it belongs to and what happened', () => {
  const search = armSearch({ iterations: 3 });
  expect(textAt(search, 0)).toBe('where the search begins');
  const { iterations } = search.answer;
  expect(textAt(search, search.answer.events.length / 3)).toBe(
    `iteration ${iterations} of ${iterations} · joint 0 turned`,
  );
  language.value = 'zh';
  expect(textAt(search, 0)).toBe('搜索起点');
  expect(textAt(armSearch({ method: 'fabrik' }), 3)).toMatch(/^第 2 次迭代，共 \d+ 次 · 后向过程$/);
});

test('what is no iteration is said without one', () => {
  expect(textAt(armSearch({ target: [9, 0, 0] }), 1)).toBe('laid straight towards the target');
});
