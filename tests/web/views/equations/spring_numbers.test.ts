import { describe, expect, it } from 'vitest';
import type { Frame, Phase } from '../../../../web/src/solver/frame.ts';
import { springNumbers } from '../../../../web/src/views/equations/spring_numbers.ts';
import { vertexMove } from '../../../../web/src/views/equations/vertex_move.ts';

/** One spring from (0, 0, 0) to (3, 4, 0), that is 5 m long; the global step then moves its second end to (3, 0, 0). */
function frameAt(phase: Phase): Frame {
  const before = Float64Array.of(0, 0, 0, 3, 4, 0);
  const after = Float64Array.of(0, 0, 0, 3, 0, 0);
  const moved = phase === 'global' || phase === 'accept';
  return {
    step: 1,
    half_step: 0,
    last_half_step: 3,
    iterations: 1,
    stopReason: 'iterations',
    phase,
    iteration: 1,
    p: moved ? after : before,
    pBefore: before,
    d: phase === 'predict' ? null : Float64Array.of(-2.4, -3.2, 0),
    pCurr: before,
    pPrev: before,
    prediction: after,
    pinned: new Int32Array(0),
    targets: new Float64Array(0),
    events: [],
    vertexEquation: null,
    stiffnessNumber: 1,
    factorisations: { count: 1, reason: 'scene' },
    rememberedSteps: 0,
    milliseconds: 0,
    profile: null,
  };
}

const spring = { index: 0, i: 0, j: 1, r: 4 };

describe('springNumbers', () => {
  it.each(['local', 'global', 'accept'] as const)('shows at %s the p that d was computed from', (phase) => {
    const { difference, length, strain, d } = springNumbers(frameAt(phase), spring);
    expect(difference).toEqual([-3, -4, 0]);
    expect(length).toBe(5);
    expect(strain).toBe(0.25);
    expect(d).toEqual([-2.4, -3.2, 0]); // 4/5 of the difference
  });

  it('has no d at predict', () => expect(springNumbers(frameAt('predict'), spring).d).toBeNull());

  it('has no strain where the rest length is 0', () => {
    expect(springNumbers(frameAt('local'), { ...spring, r: 0 }).strain).toBeNull();
  });
});

describe('vertexMove', () => {
  it('is the distance that the global step moved the vertex', () => {
    expect(vertexMove(frameAt('global'), 0)).toBe(0);
    expect(vertexMove(frameAt('global'), 1)).toBe(4);
  });
});
