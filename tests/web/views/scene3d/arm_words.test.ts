import { describe, expect, it } from 'vitest';
import { en } from '../../../../web/src/views/scene3d/arm_en.ts';
import { penText, targetText } from '../../../../web/src/views/scene3d/arm_words.ts';
import { zh } from '../../../../web/src/views/scene3d/arm_zh.ts';

describe('targetText', () => {
  it('says where the target is, and what became of it in millimetres', () => {
    expect(targetText(en, [0.6, -0.3, 0], null)).toBe('Target at x 0.600, y −0.300, z 0.000 m.');
    expect(targetText(en, [3, 1.7, 0], { outcome: 'UNREACHABLE', error: 0.4 })).toBe(
      'Target at x 3.000, y 1.700, z 0.000 m. Out of reach: the arm ends 400\u202fmm short of it.',
    );
    expect(targetText(zh, [0, 0, 1], { outcome: 'CONVERGED', error: 5e-5 })).toBe(
      '目标点位于 x 0.000、y 0.000、z 1.000 米。已到达，误差 0.0500\u202fmm。',
    );
  });
});

describe('penText', () => {
  it('says where the pen is, and whether it draws', () => {
    expect(penText(en, [0.1, -0.25], true)).toBe('Pen at x 0.10, y −0.25 m, on the floor.');
    expect(penText(zh, [0, 0], false)).toBe('画笔位于 x 0.00、y 0.00 米，已抬笔。');
  });
});
