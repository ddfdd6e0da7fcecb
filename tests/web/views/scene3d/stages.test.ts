import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Stage, stageOf } from '../../../../web/src/views/scene3d/stages.ts';
import type { Scene3DFrame } from '../../../../web/src/views/scene3d/types.ts';

const p = Float64Array.of(1, 0, 0);
const pBefore = Float64Array.of(0, 0, 0);
const prediction = Float64Array.of(0, -1, 0);
const frameAt = (phase: Scene3DFrame['phase']): Scene3DFrame => ({
  phase,
  p,
  pBefore,
  d: phase === 'predict' ? null : Float64Array.of(1, 0, 0),
  prediction,
  pinned: new Int32Array(),
  targets: new Float64Array(),
});
const phases = ['predict', 'local', 'global', 'accept'] as const;

/** x of the global view's only vertex. */
const shownX = ({ from, to, move }: Stage) => from[0] + move * (to[0] - from[0]);

describe('stageOf', () => {
  it('the finished global view always shows the iterate', () => {
    for (const phase of phases) expect(shownX(stageOf(frameAt(phase), 1))).toBe(p[0]);
  });

  it('the local step tears the left view and moves nothing in the right one', () => {
    fc.assert(
      fc.property(fc.double({ min: 0, max: 1, noNaN: true }), (progress) => {
        const stage = stageOf(frameAt('local'), progress);
        expect(stage.tear).toBe(progress);
        expect(shownX(stage)).toBe(p[0]);
        expect(stage.ghost).toBeNull();
      }),
    );
  });

  it('the global step moves the right view from the last iterate to this one, and leaves the left one torn', () => {
    const [begin, middle, end] = [0, 0.5, 1].map((progress) => stageOf(frameAt('global'), progress));
    expect([begin, middle, end].map(shownX)).toEqual([0, 0.5, 1]);
    expect([begin, middle, end].map(({ tear }) => tear)).toEqual([1, 1, 1]);
    expect(end.ghost).toBe(pBefore);
  });

  it('springs are torn from the net that their projections were computed from', () => {
    expect(phases.map((phase) => stageOf(frameAt(phase), 1).torn)).toEqual([p, p, pBefore, pBefore]);
  });

  it('at predict every spring is whole, and arrows point to where inertia would carry the net', () => {
    const stage = stageOf(frameAt('predict'), 1);
    expect(stage.d).toBeNull();
    expect(stage.ghost).toEqual(prediction);
    expect(stage.towardsGhost).toBe(true);
  });

  it('inertia carries no pin', () => {
    expect(stageOf({ ...frameAt('predict'), pinned: Int32Array.of(0), targets: p }, 1).ghost).toEqual(p);
    expect([...prediction]).toEqual([0, -1, 0]); // the frame's own array is as it was
  });

  it('tears to the frame’s projections', () => {
    for (const phase of phases) {
      const frame = frameAt(phase);
      expect(stageOf(frame, 1).d).toBe(frame.d);
    }
  });
});
