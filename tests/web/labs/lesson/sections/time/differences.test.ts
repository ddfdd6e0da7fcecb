import { expect, it } from 'vitest';
import { acceleration, straightOn, velocity } from '../../../../../../web/src/labs/lesson/sections/time/differences.ts';

// x = t², y = 3t, z = 1 at t = 0, ½, 1: powers of two, so that all is exact
const before = Float64Array.of(0, 0, 1);
const now = Float64Array.of(0.25, 1.5, 1);
const next = Float64Array.of(1, 3, 1);

it('the velocity is that half a step earlier: 2t at t = ¼', () => {
  expect([...velocity(now, before, 0.5)]).toEqual([0.5, 3, 0]);
});

it('the acceleration of a parabola is its own', () => {
  expect([...acceleration(next, now, before, 0.5)]).toEqual([2, 0, 0]);
});

it('who is left alone goes on as far again; Δt² a is what is missing', () => {
  expect([...straightOn(now, before)]).toEqual([0.5, 3, 1]);
});
