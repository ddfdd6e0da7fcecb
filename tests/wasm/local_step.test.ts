import fc from 'fast-check';
import { expect, test } from 'vitest';
import { expectOk, openMoving, openSimulation } from '../support/open_simulation.ts';
import { chain, movingScenes, usualParameters } from '../support/small_scenes.ts';

const row = (points: Float64Array, i: number) => [...points.subarray(3 * i, 3 * i + 3)];

test('every projection has its rest length and the direction of its spring', () => {
  fc.assert(
    fc.property(movingScenes, (scene) => {
      const simulation = openMoving(scene);
      expectOk(simulation.seek(1));
      const [p, d, r] = [simulation.p(), simulation.d(), simulation.r()];
      for (let e = 0; e < r.length; e++) {
        const [i, j] = scene.E.subarray(2 * e, 2 * e + 2);
        const x = row(p, i).map((coordinate, axis) => coordinate - row(p, j)[axis]);
        // A root, a division and three products, each rounded once: a few 1e-16.
        expect(Math.abs(Math.hypot(...row(d, e)) - r[e])).toBeLessThanOrEqual(1e-15 * r[e]);
        const along = x.reduce((sum, coordinate, axis) => sum + coordinate * row(d, e)[axis], 0);
        expect(Math.abs(along - Math.hypot(...x) * r[e])).toBeLessThanOrEqual(1e-15 * Math.hypot(...x) * r[e]);
      }
    }),
    { seed: 3, numRuns: 100 },
  );
});

test('at predict nothing is projected yet', () => {
  const simulation = openSimulation(chain(3), usualParameters);
  expectOk(simulation.set_state(1, Float64Array.of(0, 0, 0, 2, 0, 0, 2, 3, 0), chain(3).V, 0));
  expect([...simulation.d()]).toEqual([-2, 0, 0, 0, -3, 0]);
});

test('a collapsed spring points along +x, and its step stays finite', () => {
  const simulation = openSimulation(chain(2), usualParameters);
  expectOk(simulation.set_state(1, new Float64Array(6), new Float64Array(6), 1));
  expect([...simulation.d()]).toEqual([0.5, 0, 0]);
  expectOk(simulation.step());
});

test('a spring may rest at length zero', () => {
  const scene = { ...chain(2), V: new Float64Array(6) };
  const simulation = openSimulation(scene, usualParameters);
  expectOk(simulation.seek(1));
  expect([...simulation.r(), ...simulation.d()]).toEqual([0, 0, 0, 0]);
  expectOk(simulation.step());
  // The pin carries both: the second vertex hangs from it like a point on a rubber band.
  expect(simulation.p()[4]).toBeLessThan(0);
});
