import { describe, expect, it } from 'vitest';
import type { CurveChoice } from '../../../../../web/src/curves/curve_choice.ts';
import { curveFrom } from '../../../../../web/src/curves/curve_from.ts';
import { en } from '../../../../../web/src/labs/kinematics/drawing/en.ts';
import { zh } from '../../../../../web/src/labs/kinematics/drawing/zh.ts';
import { fillTemplate } from '../../../../../web/src/lib/fill_template.ts';

const formula = (x: string, from = '0', to = '1'): CurveChoice => ({ kind: 'formula', x, y: 't', from, to });

/** One of every problem. */
const broken: CurveChoice[] = [
  ...[
    '',
    'x'.repeat(201),
    't $',
    't +',
    'sin(t',
    't)',
    `${'('.repeat(31)}t`,
    'foo(t)',
    'sin t',
    'sin()',
    '1/t',
    '1e9',
  ].map((x) => formula(x)),
  formula('t', 't'),
  formula('t', '0', '1/0'),
  formula('t', '2', '1'),
  { ...formula('1'), y: '1' } as CurveChoice,
  { kind: 'letters', text: '€' },
  { kind: 'hand', strokes: [[[1e3, 0]]] },
  ...['M0 0 X', 'M0 0 L1', 'L1 1', 'M0 0 L1e10 1', '<svg/>', 'M0 0h1'.repeat(501)].map(
    (d): CurveChoice => ({ kind: 'path', d }),
  ),
];

const problems = broken.map((choice) => {
  const made = curveFrom(choice);
  if (made.ok) throw new Error(`${JSON.stringify(choice)} should be broken`);
  return made.problem;
});

describe('sentences about broken curves', () => {
  it('are there for every problem', () => {
    expect([...new Set(problems.map(({ code }) => code))].sort()).toEqual(Object.keys(en.problems).sort());
  });

  it.each(Object.entries({ en, zh }))('find all their values in %s', (_, words) => {
    for (const problem of problems) {
      const values = Object.fromEntries(Object.entries(problem).map(([name, value]) => [name, String(value)]));
      expect(fillTemplate(words.problems[problem.code], values)).not.toContain('undefined');
    }
  });
});
