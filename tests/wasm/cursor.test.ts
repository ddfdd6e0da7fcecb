import fc from 'fast-check';
import { expect, test } from 'vitest';
import { traceColumns } from '../../web/src/solver/module.ts';
import { expectOk, openSimulation, place } from '../support/open_simulation.ts';
import { net, usualParameters } from '../support/small_scenes.ts';
import { traceRows } from '../support/trace_rows.ts';

const parameters = { ...usualParameters, wind: true };
const last = 2 * parameters.iterations + 1;

/** At accept of time step 3. */
function stepped() {
  const simulation = openSimulation(net(4), parameters);
  for (let step = 0; step < 3; step++) expectOk(simulation.step());
  return simulation;
}

test('a scene opens at the first predict, at rest', () => {
  const scene = net(4);
  const simulation = openSimulation(scene, parameters);
  const { step, half_step, p, p_before, p_curr, p_prev } = place(simulation);
  expect({ step, half_step }).toEqual({ step: 1, half_step: 0 });
  for (const points of [p, p_before, p_curr, p_prev]) expect(points).toEqual(scene.V);
  expect(simulation.last_half_step()).toBe(last);
});

test('a cursor shows iterate ⌊h/2⌋, the iterate before it, and the projection of that one at global', () => {
  const simulation = stepped();
  expectOk(simulation.next_step());
  const places = Array.from({ length: last + 1 }, (_, h) => {
    expectOk(simulation.seek(h));
    return place(simulation);
  });
  places.forEach(({ half_step, p, p_before, d }, h) => {
    expect(half_step).toBe(h);
    expect(p).toEqual(places[2 * Math.floor(h / 2)].p);
    expect(p_before).toEqual(places[Math.max(2 * Math.floor(h / 2) - 2, 0)].p);
    if (h > 0 && h % 2 === 0) expect(d).toEqual(places[h - 1].d);
  });
  expect(places[last].d).toEqual(places[last - 1].d);
  expect(places[0].p).toEqual(places[0].p_curr);
});

test('going back and forth gives the same bits', () => {
  const simulation = stepped();
  expectOk(simulation.next_step());
  const straight = Array.from({ length: last + 1 }, (_, h) => {
    expectOk(simulation.seek(h));
    return place(simulation);
  });
  const trace = simulation.trace().slice();
  fc.assert(
    fc.property(fc.array(fc.integer({ min: 0, max: last }), { maxLength: 20 }), (visits) => {
      for (const h of visits) {
        expectOk(simulation.seek(h));
        expect(place(simulation)).toEqual(straight[h]);
      }
      expect(simulation.trace()).toEqual(trace);
    }),
    { seed: 6, numRuns: 20 },
  );
});

test('a trace does not tell in which order it was gone through', () => {
  const simulation = stepped();
  expectOk(simulation.next_step());
  const { step, p_curr, p_prev } = place(simulation);
  expectOk(simulation.seek(last));
  const straight = simulation.trace().slice();
  fc.assert(
    fc.property(fc.array(fc.integer({ min: 0, max: last }), { maxLength: 20 }), (visits) => {
      expectOk(simulation.set_state(step, p_curr, p_prev, 0)); // forgets the trace
      for (const h of visits) expectOk(simulation.seek(h));
      const furthest = Math.max(0, ...visits);
      expect(simulation.trace()).toEqual(straight.subarray(0, (furthest + 1) * traceColumns.length));
    }),
    { seed: 7, numRuns: 50 },
  );
});

test('tracing goes no further than asked, and keeps what it has', () => {
  const simulation = stepped();
  expect(simulation.trace()).toHaveLength(0); // full speed records nothing
  expectOk(simulation.seek(4));
  expect(traceRows(simulation)).toHaveLength(5);
  expectOk(simulation.seek(2));
  expect(traceRows(simulation)).toHaveLength(5);
});

test('full speed and the trace end in the same bits, from anywhere inside the time step', () => {
  const simulation = stepped();
  const atFullSpeed = place(simulation);
  for (const h of [5, 0, last]) {
    expectOk(simulation.seek(h));
    expectOk(simulation.seek(last));
    expect(place(simulation)).toEqual(atFullSpeed);
  }
  for (const h of [0, 7, 8]) {
    expectOk(simulation.seek(h));
    expectOk(simulation.step()); // completes this one
    expect(place(simulation)).toEqual(atFullSpeed);
  }
});

test('stepping back gives the same bits, as far as the history goes', () => {
  const simulation = openSimulation(net(4), parameters);
  const places = Array.from({ length: 6 }, () => {
    expectOk(simulation.step());
    return place(simulation);
  });
  expect(simulation.remembered_steps()).toBe(5);
  for (const earlier of places.slice(0, -1).reverse()) {
    expect(simulation.previous_step()).toBe(true);
    expect(place(simulation)).toEqual(earlier);
  }
  expect(simulation.previous_step()).toBe(false);
  expectOk(simulation.step());
  expect(place(simulation)).toEqual(places[1]);
});

test('going back several time steps at once gives the same bits as one by one', () => {
  const simulation = openSimulation(net(4), parameters);
  const places = Array.from({ length: 6 }, () => {
    expectOk(simulation.step());
    return place(simulation);
  });
  for (const beyond of [0, 6, 7]) expect(simulation.back_to(beyond)).toBe(false);
  expect(place(simulation)).toEqual(places[5]);
  expectOk(simulation.seek(4));
  expect(simulation.back_to(4)).toBe(true);
  expect(place(simulation)).toEqual(places[3]);
  expect(simulation.remembered_steps()).toBe(3);
  expect(simulation.back_to(1)).toBe(true);
  expect(place(simulation)).toEqual(places[0]);
  expect(simulation.remembered_steps()).toBe(0);
  expectOk(simulation.step());
  expect(place(simulation)).toEqual(places[1]);
});

test('the history keeps 300 time steps', () => {
  const simulation = openSimulation(net(2), { ...parameters, iterations: 1 });
  for (let step = 0; step < 310; step++) expectOk(simulation.step());
  expect(simulation.remembered_steps()).toBe(300);
});

test('next_step opens the time step after, and completes the one before if need be', () => {
  const simulation = stepped();
  const accepted = place(simulation);
  expectOk(simulation.seek(3));
  expectOk(simulation.next_step());
  const next = place(simulation);
  expect(next).toMatchObject({ step: 4, half_step: 0, p: accepted.p, p_curr: accepted.p, p_prev: accepted.p_curr });
  expectOk(simulation.step());
  expect(simulation.previous_step()).toBe(true);
  expect(place(simulation)).toEqual(accepted);
});

test('a checkpoint resumes in the same bits', () => {
  const simulation = stepped();
  expectOk(simulation.seek(6));
  const { step, p_curr, p_prev, half_step } = place(simulation);
  const resumed = openSimulation(net(4), parameters);
  expectOk(resumed.set_state(step, p_curr, p_prev, half_step));
  expect(place(resumed)).toEqual(place(simulation));
  expect(resumed.remembered_steps()).toBe(0);
  for (let count = 0; count < 3; count++) {
    expectOk(simulation.step());
    expectOk(resumed.step());
  }
  expect(place(resumed)).toEqual(place(simulation));
});

test('inside a time step, a change of parameters or targets is traced anew up to the same half-step', () => {
  const simulation = stepped();
  expectOk(simulation.seek(6));
  const { step, p_curr, p_prev } = place(simulation);
  const stiffer = { ...parameters, k: 2 * parameters.k };
  const targets = simulation.targets().map((coordinate) => coordinate + 0.01);
  expectOk(simulation.set_parameters(stiffer));
  expectOk(simulation.set_pins(net(4).pinned, targets));
  const fresh = openSimulation(net(4), stiffer);
  expectOk(fresh.set_pins(net(4).pinned, targets));
  expectOk(fresh.set_state(step, p_curr, p_prev, 6));
  expect(place(simulation)).toEqual(place(fresh));
  expect(simulation.trace()).toEqual(fresh.trace());
});

test('at accept, such a change leaves the accepted positions; the next time step starts from them', () => {
  const simulation = stepped();
  const accepted = place(simulation);
  const softer = { ...parameters, k: 0.5 * parameters.k, iterations: 4 };
  expectOk(simulation.set_parameters(softer));
  expectOk(
    simulation.set_pins(
      net(4).pinned,
      simulation.targets().map((coordinate) => coordinate + 0.01),
    ),
  );
  expect(place(simulation)).toEqual({ ...accepted, half_step: 9 });
  expect(simulation.trace()).toHaveLength(0);
  expectOk(simulation.next_step());
  expect(simulation.p_curr()).toEqual(accepted.p);
  // Going back, the step is made again under what holds now.
  expect(simulation.previous_step()).toBe(true);
  expect(simulation.p()).not.toEqual(accepted.p);
});

test('the same settings once more keep the trace', () => {
  const simulation = stepped();
  expectOk(simulation.seek(6));
  expectOk(simulation.seek(2));
  const { pinned } = net(4);
  expectOk(simulation.set_parameters(parameters));
  expectOk(simulation.set_pins(pinned, simulation.targets().slice()));
  expect(traceRows(simulation)).toHaveLength(7);
});

test('fewer iterations than the cursor has behind it put it at accept', () => {
  const simulation = stepped();
  expectOk(simulation.seek(14));
  expectOk(simulation.set_parameters({ ...parameters, iterations: 5 }));
  expect(simulation.half_step()).toBe(11);
});

test('reset returns to rest and lets the pins go back', () => {
  const simulation = stepped();
  const { V, pinned } = net(4);
  expectOk(simulation.set_pins(pinned, new Float64Array(6)));
  expectOk(simulation.reset());
  expect(place(simulation)).toMatchObject({ step: 1, half_step: 0, p: V, p_curr: V, p_prev: V });
  expect([...simulation.targets()]).toEqual([0, 4 / 8, 0, 3 / 8, 4 / 8, 0]);
  expect(simulation.remembered_steps()).toBe(0);
});
