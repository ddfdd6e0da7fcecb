import { describe, expect, test } from 'vitest';
import {
  compareColumns,
  type Minimiser,
  minimisers,
  type Parameters,
  type Simulation,
} from '../../web/src/solver/module.ts';
import { distance, expectOk, openSimulation, place } from '../support/open_simulation.ts';
import { net, usualParameters } from '../support/small_scenes.ts';
import { traceRows } from '../support/trace_rows.ts';

const paths = [
  { path: 'fast', storage: 'sparse' },
  { path: 'plain', storage: 'sparse' },
  { path: 'plain', storage: 'dense' },
] as const;
const everyMethod = paths.flatMap((path) => minimisers.map((method) => ({ ...path, method })));

/** A net in the middle of falling, at predict of time step 4, stiff enough that ten plain iterations leave much to do. */
function falling(parameters: Partial<Parameters>): Simulation {
  const simulation = openSimulation(net(6), { ...usualParameters, k: 1e5, ...parameters });
  for (let step = 0; step < 3; step++) expectOk(simulation.step());
  expectOk(simulation.next_step());
  return simulation;
}

/** The same instant whatever the method: reached by local and global step. */
function sameInstant(parameters: Partial<Parameters> & Pick<Parameters, 'path' | 'storage'>): Simulation {
  const { path, storage } = parameters;
  const simulation = falling({ path, storage });
  expectOk(simulation.set_parameters({ ...usualParameters, k: 1e5, ...parameters }));
  return simulation;
}

function compareRows(simulation: Simulation, method: Minimiser, iterations: number) {
  const { status, rows } = simulation.compare(method, iterations);
  expectOk(status);
  return Array.from({ length: rows.length / compareColumns.length }, (_, row) => {
    const [iteration, change, gradient] = rows.subarray(row * compareColumns.length);
    return { iteration, change, gradient };
  });
}

describe.each(everyMethod)('$method, $path, $storage', (choice) => {
  test('never raises the objective', () => {
    const simulation = falling({ ...choice, iterations: 25 }); // Chebyshev's method accelerates from the 11th on
    expectOk(simulation.seek(simulation.last_half_step()));
    const objectives = traceRows(simulation).map((row) => row.objective);
    // Objectives of about 10 J, summed from about 100 terms, are rounded by 1e-13 J.
    for (const [row, objective] of objectives.slice(1).entries())
      expect(objective).toBeLessThanOrEqual(objectives[row] + 1e-11);
    expect(objectives.at(-1)).toBeLessThan(objectives[0]);
  });

  test('gives the same bits at full speed, half-step by half-step, and there and back', () => {
    const traced = falling({ ...choice, iterations: 25 });
    const last = () => traced.last_half_step();
    const straight = [place(traced)];
    while (straight.length <= last()) {
      expectOk(traced.seek(straight.length));
      straight.push(place(traced));
    }
    for (const half_step of [0, last(), 5, 2, 3, last() - 1]) {
      expectOk(traced.seek(half_step));
      expect(place(traced)).toEqual(straight[half_step]);
    }
    const run = falling({ ...choice, iterations: 25 });
    expectOk(run.step());
    const { d: _, ...end } = place(run);
    expect(straight[last()]).toMatchObject(end);
    expect(run.stop_reason()).toBe(traced.stop_reason());
  });

  test('ends once the gradient is small', () => {
    const largest = 1; // N; gravity pulls with 9.8 N
    const simulation = sameInstant({ ...choice, iterations: 300, stop_gradient: largest });
    expectOk(simulation.step());
    expect(simulation.stop_reason()).toBe('gradient');
    expectOk(simulation.seek(2 * 300 + 1)); // beyond: to the end
    expect(simulation.half_step()).toBe(simulation.last_half_step());
    const gradients = traceRows(simulation)
      .filter((row) => row.half_step % 2 === 0)
      .map((row) => row.gradient);
    expect(simulation.last_half_step()).toBe(2 * gradients.length - 1);
    // The trace computes its gradients by other sums: the last digits of forces of k times a millimetre.
    expect(gradients.at(-1)).toBeLessThanOrEqual(largest * (1 + 1e-6));
    for (const before of gradients.slice(0, -1)) expect(before).toBeGreaterThan(largest * (1 - 1e-6));
  });

  test('ends once the objective hardly falls', () => {
    const epsilon = 1e-3;
    const simulation = sameInstant({ ...choice, iterations: 300, stop_decrease: epsilon });
    expectOk(simulation.step());
    expect(simulation.stop_reason()).toBe('decrease');
    expectOk(simulation.seek(simulation.last_half_step()));
    const objectives = traceRows(simulation)
      .filter((row) => row.half_step % 2 === 0)
      .map((row) => row.objective);
    expect(simulation.last_half_step()).toBe(2 * objectives.length - 1);
    const hardlyFalls = objectives
      .slice(1)
      .map((objective, k) => objectives[k] - objective <= epsilon * Math.max(1, Math.abs(objective)));
    expect(hardlyFalls.indexOf(true)).toBe(hardlyFalls.length - 1);
  });

  test.each([0, 1e-6])('knows a residual where it solves Q p = b, stopping at a decrease of %d', (stop_decrease) => {
    const simulation = sameInstant({ ...choice, stop_decrease });
    expectOk(simulation.seek(simulation.last_half_step()));
    for (const { half_step, residual } of traceRows(simulation)) {
      const solves = choice.method === 'local-global' && half_step > 0 && half_step % 2 === 0;
      expect(Number.isNaN(residual)).toBe(!solves);
      if (!solves) continue;
      expectOk(simulation.seek(half_step));
      const missed = Array.from({ length: simulation.vertex_count() }, (_, i) => simulation.probe_vertex(i))
        .filter((_, i) => choice.path === 'plain' || !net(6).pinned.includes(i))
        .map(({ Qp, b }) => distance(Qp, b));
      // Sums of w |p|, 1e10 N, in orders of their own.
      expect(Math.abs(residual - Math.max(...missed))).toBeLessThan(1e-5);
      expect(residual).toBeLessThan(1e-5);
    }
  });

  test('compares as it runs', () => {
    const simulation = sameInstant({ ...choice, iterations: 15 });
    const before = place(simulation);
    const rows = compareRows(simulation, choice.method, 15);
    expect(place(simulation)).toEqual(before);
    expectOk(simulation.seek(31));
    const traced = traceRows(simulation).filter((row) => row.half_step % 2 === 0);
    expect(rows.map(({ iteration }) => iteration)).toEqual(traced.map((_, k) => k));
    for (const [k, { change, gradient }] of rows.entries()) {
      // Two ways to sum up objectives of about 10 J, and forces of k times a millimetre; local and global step differ in the last digits
      // from p ← p − Q⁻¹∇E, which costs those of κ = 1e2 more.
      expect(Math.abs(change - (traced[k].objective - traced[0].objective))).toBeLessThan(1e-9);
      expect(Math.abs(gradient - traced[k].gradient)).toBeLessThan(1e-6);
    }
  });
});

describe.each(paths)('on the path $path, $storage', (path) => {
  test('no method gets below Newton’s, whose gradient is nothing but rounding', () => {
    const simulation = sameInstant(path);
    const [newton, ...others] = (['newton', 'local-global', 'chebyshev', 'anderson', 'lbfgs'] as const).map((method) =>
      compareRows(simulation, method, 1000),
    );
    const lowest = newton.at(-1);
    expect(lowest?.gradient).toBeLessThan(1e-7);
    for (const rows of others) {
      expect(rows.at(-1)?.change).toBeGreaterThan((lowest?.change ?? 0) - 1e-9);
      expect(rows[0].gradient).toBeCloseTo(newton[0].gradient, 6);
    }
  });

  test('the accelerated minimisers come closer in twenty iterations than local and global step', () => {
    const simulation = sameInstant(path);
    const [plain, ...accelerated] = minimisers.map((method) => compareRows(simulation, method, 20).at(-1)?.change);
    for (const change of accelerated) expect(change).toBeLessThan(plain ?? Number.NaN);
  });
});

test.each(minimisers)('%s keeps pinned vertices exactly where they are held on the fast path', (method) => {
  const simulation = falling({ method, path: 'fast' });
  const { V, pinned } = net(6);
  const rows = (points: Float64Array) => Array.from(pinned, (i) => [...points.subarray(3 * i, 3 * i + 3)]);
  const targets = rows(V).map((point) => point.map((coordinate) => coordinate + 0.01));
  expectOk(simulation.set_pins(pinned, Float64Array.from(targets.flat())));
  expectOk(simulation.step());
  expect(rows(simulation.p())).toEqual(targets);
});

test('a time step at rest is over before it begins', () => {
  const simulation = openSimulation(net(3), { ...usualParameters, gravity: 0, stop_gradient: 1e-9 });
  expectOk(simulation.seek(7));
  expect(simulation.half_step()).toBe(1);
  expect(simulation.last_half_step()).toBe(1);
  expect(simulation.stop_reason()).toBe('gradient');
  expectOk(simulation.step());
  expect(simulation.step_number()).toBe(2);
});

test('a change of the method leaves the factor as it is and traces anew', () => {
  const simulation = falling({});
  expectOk(simulation.seek(5));
  const factorisations = simulation.factorisation_count();
  expectOk(simulation.set_parameters({ ...usualParameters, k: 1e5, method: 'lbfgs' }));
  expect(simulation.factorisation_count()).toBe(factorisations);
  expect(simulation.half_step()).toBe(5);
});

test('Newton’s method is refused where its factor would not fit', () => {
  // 1,936 vertices, dense: the factor of Q alone takes 30 MB, and that of the Hessian has nine times its entries.
  const simulation = openSimulation(net(44), { ...usualParameters, storage: 'dense' });
  const refused = { code: 'too_large', field: 'newton', index: -1, value: expect.any(Number), limit: 300e6 };
  expect(simulation.compare('newton', 1)).toEqual({ status: refused, rows: new Float64Array(0) });
  expect(simulation.set_parameters({ ...usualParameters, storage: 'dense', method: 'newton' })).toEqual(refused);
  expectOk(simulation.step());
});
