import { describe, expect, it } from 'vitest';
import {
  netEnds,
  netPositions,
  projectedFrom,
  strain,
  tornEnds,
} from '../../../../../web/src/labs/lesson/figures/drawn_springs.ts';
import type { Scene } from '../../../../../web/src/scene/scene.ts';
import type { Frame } from '../../../../../web/src/solver/frame.ts';

// Two springs in a row along x, of rest length 1 m; the first stretched to 2 m, the second at rest.
const scene = { E: Int32Array.of(0, 1, 1, 2) } as unknown as Scene;
const p = Float64Array.of(0, 0, 0, 2, 0, 0, 3, 0, 0);
const elsewhere = p.map((x) => x + 10);
const d = Float64Array.of(-1, 0, 0, -1, 0, 0); // from j to i
const r = Float64Array.of(1, 1);
const frameAt = (phase: Frame['phase'], projections: Float64Array | null = d) =>
  ({ phase, d: projections, p: phase === 'local' ? p : elsewhere, pBefore: p }) as unknown as Frame;

describe('projectedFrom', () => {
  it('is p while that stands still, and the iterate before once a global step has moved it', () => {
    expect(projectedFrom(frameAt('local'))).toBe(p);
    expect(projectedFrom(frameAt('global'))).toBe(p);
  });
});

describe('tornEnds', () => {
  it('puts every d about the middle of its spring', () => {
    expect([...tornEnds(scene, { frame: frameAt('local'), progress: 1 })]).toEqual([
      0.5, 0, 0, 1.5, 0, 0, 2, 0, 0, 3, 0, 0,
    ]);
  });

  it('comes from the net while the local step tears it', () => {
    expect([...tornEnds(scene, { frame: frameAt('local'), progress: 0.5 })].slice(0, 6)).toEqual([
      0.25, 0, 0, 1.75, 0, 0,
    ]);
    expect(tornEnds(scene, { frame: frameAt('local'), progress: 0 })).toEqual(netEnds(scene, p));
  });

  it('is the net as long as there is no d', () => {
    expect(tornEnds(scene, { frame: { ...frameAt('local', null), phase: 'predict' }, progress: 1 })).toEqual(
      netEnds(scene, p),
    );
  });
});

describe('netPositions', () => {
  it('go from the iterate before to the new one while the global step moves them', () => {
    expect([...netPositions({ frame: frameAt('global'), progress: 0.5 })].slice(0, 3)).toEqual([5, 5, 5]);
    expect(netPositions({ frame: frameAt('local'), progress: 0.5 })).toBe(p);
  });
});

describe('strain', () => {
  it('compares a spring’s length with its rest length', () => {
    expect([0, 1].map((e) => strain(netEnds(scene, p), e, r))).toEqual([1, 0]);
  });

  it('is none where the rest length is', () => {
    expect(strain(netEnds(scene, p), 0, Float64Array.of(0, 1))).toBe(0);
  });
});
