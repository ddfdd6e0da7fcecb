import { describe, expect, test } from 'vitest';
import { type Method, methods, minimisers, type Parameters, type Simulation } from '../../web/src/solver/module.ts';
import { openScene } from '../support/open_scene.ts';
import { distance, expectOk, openSimulation, place } from '../support/open_simulation.ts';
import { net, type SmallScene, usualParameters } from '../support/small_scenes.ts';
import { traceRows } from '../support/trace_rows.ts';

/** Δt ω is about 0.1, far from where any method explodes within some steps. */
const gentle: Parameters = { ...usualParameters, path: 'fast', delta_t: 1e-3, gravity: 0, iterations: 100 };

/** Two masses of 1 kg on a line, joined by a spring 1 m long. */
const pair: SmallScene = {
  V: Float64Array.of(0, 0, 0, 1, 0, 0),
  E: Int32Array.of(0, 1),
  m: Float64Array.of(1, 1),
  pinned: new Int32Array(),
};

/** Reproducible numbers between −1 and 1. */
function scattered(length: number): Float64Array {
  return Float64Array.from({ length }, (_, c) => 2 * ((0.618034 * (c + 1)) % 1) - 1);
}

/** The net off its rest positions and moving. */
function moving(scene: SmallScene, parameters: Parameters): Simulation {
  const simulation = openSimulation(scene, parameters);
  const p_curr = scene.V.map((x, c) => x + 0.02 * scattered(scene.V.length)[c]);
  const p_prev = p_curr.map((x, c) => x - 0.5 * parameters.delta_t * scattered(scene.V.length)[c]);
  expectOk(simulation.set_state(1, p_curr, p_prev, 0));
  return simulation;
}

function run(simulation: Simulation, steps: number): void {
  for (let step = 0; step < steps; step++) expectOk(simulation.step());
}

/** Σ m_i v_i, kg·m/s. */
function momentum(simulation: Simulation, { m }: SmallScene): number[] {
  const v = simulation.velocity();
  return [0, 1, 2].map((axis) => m.reduce((sum, mass, i) => sum + mass * v[3 * i + axis], 0));
}

describe.each(methods)('%s', (method) => {
  test('leaves at rest what is at rest', () => {
    const scene = net(5);
    const simulation = openSimulation(scene, { ...gentle, damping: 2, method });
    run(simulation, 20);
    // Solving Q p = b rounds 20 times to 1e-16 of some metres, each error carried on by its velocity.
    expect(distance(simulation.p(), scene.V)).toBeLessThan(1e-13);
    expect(simulation.energy().springs).toBeLessThan(1e-20);
  });

  test('keeps the momentum where nothing is fixed, dashpots or not', () => {
    const scene = { ...net(5), pinned: new Int32Array() };
    const simulation = moving(scene, { ...gentle, damping: 2, method });
    const before = momentum(simulation, scene);
    run(simulation, 20);
    // 25 kg at up to 0.5 m/s; positions of 1 m are rounded to 1e-16, velocities to that over Δt. L-BFGS, which ends once E falls by no more
    // than its rounding, leaves a gradient of about 1e-5 N, and that makes a momentum in Δt.
    expect(distance(momentum(simulation, scene), before)).toBeLessThan(method === 'lbfgs' ? 1e-6 : 1e-10);
  });

  test('holds what is fixed exactly where it is held, also while it is moved', () => {
    const scene = net(5);
    const simulation = moving(scene, { ...gentle, method });
    for (let step = 1; step <= 5; step++) {
      const targets = Float64Array.of(0, 0.625 + 1e-3 * step, 0, 0.5, 0.625, 0);
      expectOk(simulation.set_pins(scene.pinned, targets));
      run(simulation, 1);
      const p = simulation.p();
      expect([...p.subarray(0, 3), ...p.subarray(12, 15)]).toEqual([...targets]);
    }
  });

  test('makes the same bits forwards, half-step by half-step, and back again', () => {
    const straight = moving(net(5), { ...gentle, method });
    const traced = moving(net(5), { ...gentle, method });
    const places: ReturnType<typeof place>[] = [];
    for (let step = 1; step <= 4; step++) {
      run(straight, 1);
      expectOk(traced.seek(traced.last_half_step()));
      expect(place(traced).p).toEqual(place(straight).p);
      expect(traced.velocity()).toEqual(straight.velocity());
      places.push(place(traced));
      if (step < 4) expectOk(traced.next_step());
    }
    for (const step of [3, 1]) {
      expect(traced.back_to(step)).toBe(true);
      expect(place(traced)).toEqual(places[step - 1]);
    }
  });
});

test('the first step of each kind from rest under gravity, by hand', () => {
  // One mass of 1 kg falls freely: v = −9.8 Δt after the step; forward Euler moves with the velocity before it.
  const scene = { ...pair, pinned: new Int32Array() };
  for (const method of methods) {
    const simulation = openSimulation(scene, { ...gentle, gravity: 9.8, method });
    run(simulation, 1);
    const fallen = method === 'forward-euler' ? 0 : -9.8e-6; // m
    expect(simulation.p()[1]).toBeCloseTo(fallen, 15);
    expect(simulation.velocity()[1]).toBeCloseTo(-9.8e-3, 12);
    const { kinetic, external } = simulation.energy();
    expect(kinetic).toBeCloseTo((2 * 9.8e-3 ** 2) / 2, 12);
    expect(external).toBeCloseTo(2 * 9.8 * fallen, 12);
  }
});

test.each(['linearly-implicit', 'newton', 'local-global'] as const)(
  'two masses on a line follow the recurrence of implicit Euler: %s',
  (method) => {
    const simulation = openSimulation(pair, { ...gentle, delta_t: 0.01, method });
    const start = Float64Array.of(-0.1, 0, 0, 1.1, 0, 0);
    expectOk(simulation.set_state(1, start, start, 0));
    // Of the stretch x, with ω² = k (1/m + 1/m): v' = (v − Δt ω² x)/(1 + Δt² ω²), x' = x + Δt v'.
    const squared = 2 * gentle.k; // 1/s²
    let [x, v] = [0.2, 0];
    for (let step = 0; step < 200; step++) {
      run(simulation, 1);
      v = (v - 0.01 * squared * x) / (1 + 1e-4 * squared);
      x += 0.01 * v;
      const p = simulation.p();
      expect(Math.abs(p[3] - p[0] - 1 - x)).toBeLessThan(1e-11);
    }
  },
);

test('Newton, run to its end, and local/global, run long, find the same minimiser of a soft cloth', async () => {
  const cloth = await openScene('cloth');
  const soft: Parameters = { ...gentle, k: 10, delta_t: cloth.delta_t, gravity: cloth.gravity, damping: cloth.damping };
  const at = (method: Method, iterations: number) => {
    const simulation = moving(cloth, { ...soft, method, iterations });
    run(simulation, 1);
    return simulation.p().slice();
  };
  const size = 2 * Math.SQRT2; // m: of the cloth
  expect(distance(at('local-global', 2000), at('newton', 50))).toBeLessThan(1e-7 * size);
  for (const method of ['lbfgs', 'anderson', 'chebyshev'] as const) {
    expect(distance(at(method, 500), at('newton', 50))).toBeLessThan(1e-7 * size);
  }
});

test('linearly implicit Euler is one step of Newton, where that needs neither line search nor caution', () => {
  // Springs longer than at rest only: E is convex, and from nearby a whole step lowers it.
  const scene = { ...net(5), pinned: new Int32Array() };
  const stretched = scene.V.map((x) => 1.3 * x);
  const [linear, newton] = (['linearly-implicit', 'newton'] as const).map((method) => {
    const simulation = openSimulation(scene, { ...gentle, delta_t: 0.01, damping: 3, iterations: 1, method });
    expectOk(simulation.set_state(1, stretched, stretched, 0));
    run(simulation, 1);
    return simulation.p().slice();
  });
  // Two factorisations of the same matrix, whose condition is below 100.
  expect(distance(linear, newton)).toBeLessThan(1e-13);
});

test('dashpots take energy, whatever the method, and none from what moves as one', () => {
  for (const method of methods) {
    const energyAfter = (damping: number) => {
      const scene = { ...net(5), pinned: new Int32Array() };
      const simulation = moving(scene, { ...gentle, damping, method });
      run(simulation, 100);
      const { kinetic, springs } = simulation.energy();
      return kinetic + springs;
    };
    const [without, with_] = [energyAfter(0), energyAfter(5)];
    expect(with_).toBeLessThan(0.9 * without);
  }
  const whole = openSimulation({ ...pair }, { ...gentle, damping: 5, method: 'symplectic-euler' });
  expectOk(
    whole.set_state(
      1,
      pair.V,
      pair.V.map((x, c) => x - (c % 3 === 0 ? 1e-3 : 0)),
      0,
    ),
  );
  run(whole, 100);
  // 1 m/s for 0.1 s, 100 roundings.
  expect(whole.p()[0]).toBeCloseTo(0.1, 12);
});

describe('a pull', () => {
  const pulled = Int32Array.of(1);
  const target = Float64Array.of(1, 0.5, 0);
  const k = 1e5;

  test.each([...minimisers, 'linearly-implicit'] as const)('draws a lone mass in one implicit step: %s', (method) => {
    const lone = { V: pair.V, E: new Int32Array(), m: pair.m, pinned: new Int32Array() };
    const simulation = openSimulation(lone, { ...gentle, method });
    expectOk(simulation.set_pull(pulled, target, k));
    expect(simulation.factorisation_reason()).toBe('pull');
    run(simulation, 1);
    // (m/Δt² + k) y = k y_target.
    expect(simulation.p()[4]).toBeCloseTo((0.5 * k) / (1e6 + k), 13);
    expect(simulation.p()[1]).toBe(0);
  });

  test('is factorised for once, not for every move of its target, and ends with a reset', () => {
    const simulation = openSimulation(net(5), gentle);
    const factorisations = () => simulation.factorisation_count();
    const before = factorisations();
    expectOk(simulation.set_pull(pulled, target, k));
    expectOk(simulation.set_pull(pulled, Float64Array.of(1, 0.6, 0), k));
    expect(factorisations()).toBe(before + 1);
    run(simulation, 3);
    expectOk(simulation.reset());
    expect(factorisations()).toBe(before + 2);
    run(simulation, 3);
    expect(distance(simulation.p(), net(5).V)).toBeLessThan(1e-14);
  });

  test('is refused with what is wrong with it, and the one before stays', () => {
    const simulation = openSimulation(net(5), gentle);
    expect(simulation.set_pull(Int32Array.of(25), target, k)).toMatchObject({
      code: 'index_out_of_range',
      field: 'pulled',
      index: 0,
      value: 25,
    });
    expect(simulation.set_pull(Int32Array.of(1, 1), new Float64Array(6), k).code).toBe('duplicate_vertex');
    expect(simulation.set_pull(pulled, Float64Array.of(0, 0), k)).toMatchObject({ code: 'wrong_length', value: 2 });
    expect(simulation.set_pull(pulled, Float64Array.of(0, Number.NaN, 0), k).code).toBe('not_finite');
    expect(simulation.set_pull(pulled, target, -1)).toMatchObject({ code: 'negative', field: 'pull', value: -1 });
    run(simulation, 3);
    expect(distance(simulation.p(), net(5).V)).toBeLessThan(1e-14);
  });
});

describe('the stable region', () => {
  /** The pair stretched by a millimetre, Δt ω as asked, ω² = 2k/m. */
  const swinging = (method: Method, delta_t_omega: number, damping = 0) => {
    const delta_t = delta_t_omega / Math.sqrt(2 * gentle.k);
    const simulation = openSimulation(pair, { ...gentle, method, delta_t, damping });
    const start = Float64Array.of(0, 0, 0, 1.001, 0, 0);
    expectOk(simulation.set_state(1, start, start, 0));
    return simulation;
  };

  test('is told: ω of the spring, and what Δt ω may be', () => {
    expect(swinging('symplectic-euler', 1).largest_frequency()).toBeCloseTo(Math.sqrt(2 * gentle.k), 6);
    expect(swinging('symplectic-euler', 1).stability_limit()).toBe(2);
    expect(swinging('forward-euler', 1).stability_limit()).toBe(0);
    expect(swinging('newton', 1).stability_limit()).toBe(Number.POSITIVE_INFINITY);
    // ζ = cω/(2k) = 0.5 for c = k/ω: the roots of a damped forward step leave the unit circle at Δt ω = 2ζ.
    expect(swinging('forward-euler', 1, gentle.k / Math.sqrt(2 * gentle.k)).stability_limit()).toBeCloseTo(1, 6);
  });

  test.each(['symplectic-euler', 'forward-euler'] as const)(
    'once %s has left it, the step that goes too far is refused with the reason, and the state before stays',
    (method) => {
      const simulation = swinging(method, 3.1);
      let status = simulation.step();
      let before = place(simulation);
      for (let step = 0; step < 1000 && status.code === 'ok'; step++) {
        before = place(simulation);
        status = simulation.step();
      }
      expect(status).toMatchObject({ code: 'unstable', field: method, limit: method === 'symplectic-euler' ? 2 : 0 });
      expect(status.value).toBeCloseTo(3.1, 12);
      expect(place(simulation)).toEqual(before);
      expect(before.p.every(Number.isFinite)).toBe(true);
      expectOk(simulation.reset());
      run(simulation, 3);
    },
  );
});

test('the reason names the ω of the springs at rest, not that of how they lie when they have exploded', async () => {
  const rabbit = await openScene('rabbit');
  const { k, delta_t } = rabbit;
  const simulation = openSimulation(rabbit, { ...gentle, k, delta_t, gravity: 9.8, method: 'symplectic-euler' });
  const product = delta_t * simulation.largest_frequency();
  let status = simulation.step();
  for (let step = 0; step < 100 && status.code === 'ok'; step++) status = simulation.step();
  expect(status).toEqual({ code: 'unstable', field: 'symplectic-euler', index: -1, value: product, limit: 2 });
});

test.each(['symplectic-euler', 'forward-euler'] as const)(
  '%s: what only falls far is not called unstable',
  (method) => {
    const falling = {
      V: Float64Array.of(0, 0, 0),
      E: new Int32Array(),
      m: Float64Array.of(1),
      pinned: new Int32Array(),
    };
    const simulation = openSimulation(falling, { ...gentle, delta_t: 300, gravity: 9.8, method });
    // −9.8 Δt² times 1, 3, …; forward Euler a step later: the second is beyond a million metres.
    run(simulation, method === 'forward-euler' ? 2 : 1);
    const status = simulation.step();
    expect(status).toMatchObject({ code: 'diverged', field: 'p', index: 0, limit: 1e6 });
    expect(status.value).toBeCloseTo(3 * 9.8 * 300 ** 2, 6);
  },
);

test('local/global lowers E with dashpots and a pull too, and the surrogate lies on it or above', () => {
  const simulation = moving(net(5), { ...gentle, damping: 50, delta_t: 0.01, iterations: 20 });
  expectOk(simulation.set_pull(Int32Array.of(12), Float64Array.of(0.5, 0.5, 0.5), 1e4));
  expectOk(simulation.seek(simulation.last_half_step()));
  const rows = traceRows(simulation);
  const allowed = 1e-12 * rows[0].objective; // without gravity none of its terms is negative: their rounding
  for (const [half_step, { objective, surrogate }] of rows.entries()) {
    expect(surrogate).toBeGreaterThanOrEqual(objective - allowed);
    if (half_step === 0) continue;
    const isLocal = half_step % 2 === 1 && half_step < simulation.last_half_step();
    if (isLocal) expect(Math.abs(surrogate - objective)).toBeLessThan(allowed);
    expect(objective).toBeLessThanOrEqual(rows[half_step - 1].objective + allowed);
    expect(surrogate).toBeLessThanOrEqual(rows[half_step - 1].surrogate + allowed);
  }
});

test('a method, a pull or dashpots that come when a time step is done change nothing of the motion so far', () => {
  for (const method of methods) {
    const simulation = moving(net(5), { ...gentle, method });
    run(simulation, 3);
    const [p, v, energy] = [simulation.p().slice(), simulation.velocity(), simulation.energy()];
    expectOk(simulation.set_pull(Int32Array.of(7), Float64Array.of(1, 1, 1), 1e5));
    expectOk(simulation.set_pins(Int32Array.of(4, 1), Float64Array.of(0.5, 0.625, 0, 0.125, 0.7, 0)));
    for (const next of methods) {
      expectOk(simulation.set_parameters({ ...gentle, damping: 3, method: next }));
      expect([simulation.p(), simulation.velocity(), simulation.energy()]).toEqual([p, v, energy]);
    }
  }
});

test.each(methods)('%s: in which order pins are listed, and when they came to be so, changes no bit', (method) => {
  const orders = [Int32Array.of(0, 4, 12), Int32Array.of(12, 0, 4)];
  const held = (order: Int32Array) =>
    Float64Array.from([...order].flatMap((i) => [...net(5).V.subarray(3 * i, 3 * i + 3)]));
  const [first, second] = [0, 1].map((begins) => {
    const simulation = moving({ ...net(5), pinned: orders[begins] }, { ...gentle, damping: 2, method });
    expectOk(simulation.set_pins(orders[1], held(orders[1])));
    run(simulation, 3);
    return simulation.p().slice();
  });
  expect(first).toEqual(second);
});

test('methods change while it runs: positions and velocities stay', () => {
  const simulation = moving(net(5), { ...gentle, method: 'forward-euler' });
  for (const method of [...methods, 'forward-euler'] as const) {
    run(simulation, 3);
    const [p, v] = [simulation.p().slice(), simulation.velocity().slice()];
    expectOk(simulation.set_parameters({ ...gentle, method }));
    const p_prev = p.map((x, c) => x - gentle.delta_t * v[c]);
    expectOk(simulation.set_state(simulation.step_number() + 1, p, p_prev, 0));
    expect(simulation.p()).toEqual(p);
    // Positions of 1 m rounded to 1e-16, over Δt.
    expect(distance(simulation.velocity(), v)).toBeLessThan(1e-12);
  }
});
