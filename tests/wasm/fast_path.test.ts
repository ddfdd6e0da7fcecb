import fc from 'fast-check';
import { expect, test } from 'vitest';
import { distance, expectOk, openMoving, openSimulation, place } from '../support/open_simulation.ts';
import { gentleScenes, type MovingScene, movingScenes, net, usualParameters } from '../support/small_scenes.ts';
import { traceRows } from '../support/trace_rows.ts';

const onPath = (scene: MovingScene, path: 'fast' | 'plain', more = {}): MovingScene => ({
  ...scene,
  parameters: { ...scene.parameters, ...more, path },
});

test('its iterates are those of the plain path, but that pins do not drift', () => {
  fc.assert(
    fc.property(gentleScenes, fc.constantFrom(1, 2, 10), (scene, iterations) => {
      const w = 1e12;
      const [fast, plain] = (['fast', 'plain'] as const).map((path) => {
        const simulation = openMoving(onPath(scene, path, { w, iterations }));
        expectOk(simulation.step());
        return simulation.p().slice();
      });
      // m: rounding, and what the pins drift on the plain path, reaction/w. They hold at most 9 springs, stretched by at most 5 cm, and
      // 10 kg that would move by at most 5 cm; a direction that the drift turns makes it no more than ten times as much.
      const { k, delta_t } = scene.parameters;
      const drift = (0.05 * (9 * k + 10 / delta_t ** 2)) / w;
      expect(distance(fast, plain)).toBeLessThan(1e-9 + 10 * drift);
    }),
  );
});

test('pins are exactly where they are held', () => {
  fc.assert(
    fc.property(movingScenes, (scene) => {
      const simulation = openMoving(onPath(scene, 'fast'));
      expectOk(simulation.step());
      const p = simulation.p();
      const held = [...scene.pinned].flatMap((vertex) => [...p.subarray(3 * vertex, 3 * vertex + 3)]);
      expect(held).toEqual([...scene.targets]);
    }),
  );
});

test('its trace ends in the bits of the full-speed step, and can be walked back', () => {
  fc.assert(
    fc.property(movingScenes, fc.nat(40), (scene, anywhere) => {
      const simulation = openMoving(onPath(scene, 'fast'));
      expectOk(simulation.step());
      const atSpeed = place(simulation);
      expectOk(simulation.seek(anywhere % simulation.last_half_step()));
      expectOk(simulation.seek(simulation.last_half_step()));
      expect(place(simulation)).toEqual(atSpeed);
    }),
  );
});

test('no half-step raises the objective or the surrogate', () => {
  fc.assert(
    fc.property(gentleScenes, (scene) => {
      const simulation = openMoving(onPath(scene, 'fast'));
      expectOk(simulation.seek(simulation.last_half_step()));
      const rows = traceRows(simulation);
      rows.slice(1).forEach((row, index) => {
        // 1e-8 J: rounding of terms of up to 1e4 J, as for the plain path
        expect(row.objective).toBeLessThanOrEqual(rows[index].objective + 1e-8);
        if (index > 0) expect(row.surrogate).toBeLessThanOrEqual(rows[index].surrogate + 1e-8);
      });
    }),
  );
});

test('solves the equations of every vertex that is not pinned', () => {
  const simulation = openSimulation(net(6), { ...usualParameters, path: 'fast' });
  expectOk(simulation.seek(4));
  const { b, Qp } = simulation.probe_vertex(14);
  for (const axis of [0, 1, 2]) expect(Math.abs(b[axis] - Qp[axis])).toBeLessThan(1e-9); // of about 1e3 N
  expect(traceRows(simulation)[4].residual).toBeLessThan(1e-9);
});

test('the pins in another order are the same pins', () => {
  const scene = net(5);
  const simulations = [
    [0, 4],
    [4, 0],
  ].map((pinned) => {
    const simulation = openSimulation(scene, { ...usualParameters, path: 'fast' });
    const targets = pinned.flatMap((vertex) => [...scene.V.subarray(3 * vertex, 3 * vertex + 3)]);
    expectOk(simulation.set_pins(Int32Array.from(pinned), Float64Array.from(targets)));
    expectOk(simulation.step());
    return simulation;
  });
  expect(simulations[1].p()).toEqual(simulations[0].p());
  expect(simulations[1].factorisation_count()).toBe(1);
});

test('knows no w: only the plain path factorises for it', () => {
  const parameters = { ...usualParameters, path: 'fast' } as const;
  const simulation = openSimulation(net(4), parameters);
  expectOk(simulation.set_parameters({ ...parameters, w: 1e4 }));
  expect(simulation.factorisation_count()).toBe(1);
  expectOk(simulation.set_parameters({ ...parameters, w: 1e4, path: 'plain' }));
  expect([simulation.factorisation_count(), simulation.factorisation_reason()]).toEqual([2, 'path']);
});

test('refuses before work starts what would not fit, and the scene before goes on', () => {
  const simulation = openSimulation(net(4), { ...usualParameters, path: 'fast' });
  expectOk(simulation.step());
  const before = place(simulation);
  const { V, E } = block(42);
  const status = simulation.set_scene(V, E, new Float64Array(V.length / 3).fill(1), Int32Array.of(0), {
    ...usualParameters,
    path: 'fast',
  });
  expect(status).toMatchObject({ code: 'too_large', field: 'factor', limit: 180e6 });
  expect(status.value).toBeGreaterThan(status.limit);
  expect(place(simulation)).toEqual(before);
  expectOk(simulation.step());
});

/** n³ vertices on a grid, each joined to its neighbours along the axes and one diagonal: much fill. */
function block(n: number) {
  const V: number[] = [];
  const E: number[] = [];
  const at = (x: number, y: number, z: number) => (z * n + y) * n + x;
  for (let z = 0; z < n; z++)
    for (let y = 0; y < n; y++)
      for (let x = 0; x < n; x++) {
        V.push(x, y, z);
        for (const [dx, dy, dz] of [
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
          [1, 1, 1],
        ])
          if (x + dx < n && y + dy < n && z + dz < n) E.push(at(x, y, z), at(x + dx, y + dy, z + dz));
      }
  return { V: Float64Array.from(V), E: Int32Array.from(E) };
}
