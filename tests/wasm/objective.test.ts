import fc from 'fast-check';
import { expect, test } from 'vitest';
import { distance, expectOk, openMoving, openSimulation } from '../support/open_simulation.ts';
import { chain, gentleScenes, type MovingScene, movingScenes, net, usualParameters } from '../support/small_scenes.ts';
import { type TraceRow, traceRows } from '../support/trace_rows.ts';

/** No half-step raises the objective or the surrogate, and the surrogate never lies below. */
function expectDescent(scene: MovingScene, slack: (start: TraceRow) => number): void {
  const simulation = openMoving(scene);
  expectOk(simulation.seek(simulation.last_half_step()));
  const rows = traceRows(simulation);
  const allowed = slack(rows[0]);
  expect(rows.map((row) => row.half_step)).toEqual(rows.map((_, half_step) => half_step));
  rows.forEach((row, half_step) => {
    expect(row.surrogate).toBeGreaterThanOrEqual(row.objective - allowed);
    if (half_step === 0) return;
    expect(row.objective).toBeLessThanOrEqual(rows[half_step - 1].objective + allowed);
    expect(row.surrogate).toBeLessThanOrEqual(rows[half_step - 1].surrogate + allowed);
    const isLocal = half_step % 2 === 1 && half_step < simulation.last_half_step();
    if (isLocal) expect(Math.abs(row.surrogate - row.objective)).toBeLessThanOrEqual(allowed);
  });
}

test('no half-step raises the objective, however wild the motion', () => {
  // Rounding may raise E by 1e-12 of the size of its terms at the start of the time step.
  const slack = ({ potential, inertia, external, pin }: TraceRow) =>
    1e-12 * [potential, inertia, external, pin].reduce((sum, term) => sum + Math.abs(term), 0);
  fc.assert(
    fc.property(movingScenes, (scene) => expectDescent(scene, slack)),
    { seed: 4, numRuns: 200 },
  );
});

test('nor where the motion is gentle, to the last digits of a joule', () => {
  // 1e-12 of 1e4 J.
  fc.assert(
    fc.property(gentleScenes, (scene) => expectDescent(scene, () => 1e-8)),
    { seed: 4, numRuns: 200 },
  );
});

test('the columns of the trace are what they are called', () => {
  // A stiff net a kilometre away: there p is rounded to 1e-13 m, which the springs turn into a residual of 1e-5 N.
  const { V, ...scene } = net(3);
  const away = V.map((coordinate, c) => (c % 3 === 0 ? coordinate + 1000 : coordinate));
  const simulation = openSimulation({ ...scene, V: away }, { ...usualParameters, k: 1e8, w: 1e4 });
  expectOk(simulation.step());
  expectOk(simulation.next_step());
  expectOk(simulation.seek(simulation.last_half_step()));
  const rows = traceRows(simulation);
  for (const row of rows) {
    expectOk(simulation.seek(row.half_step));
    const { objective, potential, inertia, external, pin } = simulation.objective_at(simulation.p().slice());
    expect(row).toMatchObject({ objective, potential, inertia, external, pin });
    const isGlobal = row.half_step > 0 && row.half_step % 2 === 0;
    if (!isGlobal) {
      expect(row).toMatchObject({ residual: Number.NaN, change: 0 });
      continue;
    }
    const [p, before] = [simulation.p(), simulation.p_before()];
    const moved = Array.from({ length: 9 }, (_, i) => {
      const step = [0, 1, 2].map((axis) => p[3 * i + axis] - before[3 * i + axis]);
      return Math.hypot(...step);
    });
    expect(row.change).toBeCloseTo(Math.max(...moved), 15);
    const left = Array.from({ length: 9 }, (_, i) => {
      const { Qp, b } = simulation.probe_vertex(i);
      return distance(Qp, b);
    });
    // b is 1e7 N, and each sum is rounded in an order of its own.
    expect(Math.abs(row.residual - Math.max(...left))).toBeLessThan(1e-7);
    expect(row.residual).toBeGreaterThan(1e-6);
  }
});

test('the gradient agrees with central differences', () => {
  const simulation = openSimulation(net(4), { ...usualParameters, w: 1e4, wind: true });
  expectOk(simulation.step());
  expectOk(simulation.next_step());
  // Away from every minimum, by a fixed irregular pattern.
  const p = simulation.p().map((coordinate, c) => coordinate + 0.05 * Math.sin(7 * c * c));
  const gradient = simulation.gradient_at(p).slice();
  const h = 1e-5; // m
  const differences = p.map((coordinate, c) => {
    const [above, below] = [coordinate + h, coordinate - h].map(
      (moved) => simulation.objective_at(p.with(c, moved)).objective,
    );
    return (above - below) / (2 * h);
  });
  // E is about 1e4 J: rounded to 1e-12 J, divided by 2h. The third derivative adds k h²/l², about 1e-5 N.
  expect(distance(differences, gradient)).toBeLessThan(1e-4);
  expect(Math.max(...gradient.map(Math.abs))).toBeGreaterThan(10);
});

test('the gradient vanishes where inertia and gravity alone carry a free vertex', () => {
  const falling = { ...chain(1), E: new Int32Array(), pinned: new Int32Array() };
  const simulation = openSimulation(falling, usualParameters);
  expectOk(simulation.set_state(1, Float64Array.of(1, 2, 3), Float64Array.of(1, 2, 2), 0));
  // m/Δt² = 900 N/m times a rounding of 1e-16 m.
  expect(distance(simulation.gradient_at(simulation.inertial_prediction().slice()), [0, 0, 0])).toBeLessThan(1e-11);
});

test('Q p − b is the gradient at the p that d was projected from', () => {
  const simulation = openSimulation(net(3), { ...usualParameters, w: 1e4 });
  expectOk(simulation.step());
  expectOk(simulation.next_step());
  expectOk(simulation.seek(3));
  const gradient = simulation.gradient_at(simulation.p().slice()).slice();
  for (let i = 0; i < 9; i++) {
    const { y, kAtd, b, Qp } = simulation.probe_vertex(i);
    expect(b).toEqual(kAtd.map((part, axis) => part + y[axis]));
    // Numbers up to 1e4, rounded.
    expect(
      distance(
        Qp.map((left, axis) => left - b[axis]),
        gradient.subarray(3 * i, 3 * i + 3),
      ),
    ).toBeLessThan(1e-10);
  }
});

test('what is asked at a p of another length, or of a vertex that is not there, has no number for an answer', () => {
  const simulation = openSimulation(chain(2), usualParameters);
  expect(simulation.objective_at(new Float64Array(3)).objective).toBeNaN();
  expect(simulation.gradient_at(new Float64Array(3))).toHaveLength(0);
  expect(simulation.probe_vertex(2).b).toEqual([Number.NaN, Number.NaN, Number.NaN]);
});
