import { beforeEach, expect, onTestFinished, test, vi } from 'vitest';
import { notices } from '../../../web/src/app/notices.ts';
import { SideBySide } from '../../../web/src/app/side_by_side.ts';
import type { Scene } from '../../../web/src/scene/scene.ts';
import { SideBySideSession } from '../../../web/src/solver/side_by_side.ts';
import { solver } from '../../support/open_simulation.ts';
import { PortWorker } from '../../support/port_worker.ts';
import { net, usualParameters } from '../../support/small_scenes.ts';

const wasm = new ArrayBuffer(0); // the fake worker's module is there already

const { V, E, m, pinned } = net(3);
const scene: Scene = {
  ...{ name: 'net', F: new Uint32Array(0), texture: null, k: 1e3, delta_t: 1 / 30, iterations: 10, w: 1e10 },
  ...{ gravity: 9.8, damping: 0 },
  ...{ V, E, m, pinned },
};
const pins = { pinned, targets: Float64Array.from([...pinned].flatMap((i) => [...V.subarray(3 * i, 3 * i + 3)])) };
const variants = [1, 10].map((iterations) => ({
  parameters: { ...usualParameters, iterations },
  substeps: 1,
  mistake: 'none' as const,
}));

let workers: PortWorker[] = [];
beforeEach(() => {
  workers = [];
  notices.value = [];
});

function newRun(): SideBySide {
  const createWorker = () => {
    const session = new SideBySideSession(solver);
    const worker = new PortWorker({
      start: async () => {},
      open: async (...request: Parameters<SideBySideSession['open']>) => session.open(...request),
      change: async (...request: Parameters<SideBySideSession['change']>) => session.change(...request),
      run: async (...request: Parameters<SideBySideSession['run']>) => session.run(...request),
      sameInstant: async (...request: Parameters<SideBySideSession['sameInstant']>) => session.sameInstant(...request),
    });
    workers.push(worker);
    return worker.asWorker();
  };
  const run = new SideBySide(createWorker, async () => wasm);
  onTestFinished(() => {
    for (const worker of workers) worker.terminate();
  });
  return run;
}

test('steps are made, and their energies remembered, until all begins again', async () => {
  const run = newRun();
  expect(await run.open(variants, { scene, pins, from: null })).toBe(true);
  const atRest = run.states.value?.map(({ p }) => p);
  await run.run(3);
  await run.run(2);
  expect(run.step.value).toBe(5);
  expect(run.energies.value.map((curve) => curve.length)).toEqual([5, 5]);
  await run.reset();
  expect(run.step.value).toBe(0);
  expect(run.energies.value.map((curve) => curve.length)).toEqual([0, 0]);
  expect(run.states.value?.map(({ p }) => p)).toEqual(atRest);
});

test('a pin that is moved moves for all; another vertex cannot be', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  run.movePin(pinned[0], [-1, 2, 3]);
  run.movePin(8, [9, 9, 9]);
  expect([...run.pins.value.targets]).toEqual([-1, 2, 3, ...pins.targets.subarray(3)]);
  await run.run(1);
  const at = 3 * pinned[0];
  // The penalised pin drifts by its reaction over w: some 10 N over 1e10 N/m.
  for (const { p } of run.states.value ?? [])
    expect(Math.hypot(p[at] + 1, p[at + 1] - 2, p[at + 2] - 3)).toBeLessThan(1e-5);
});

test('a refusal is said, and what was open stays', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  const refused = [{ ...variants[0], parameters: { ...usualParameters, k: -1 } }];
  expect(await run.open(refused, { scene, pins, from: null })).toBe(false);
  expect(notices.value).toMatchObject([{ key: 'page.errors.not_positive' }]);
  await run.run(2);
  expect(run.energies.value.map((curve) => curve.length)).toEqual([2, 2]);
});

test('a worker that breaks is ended and said, and the next opening finds a new one', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  const asked = run.run(1);
  workers[0].break('unreachable');
  await asked;
  expect(workers[0].ended).toBe(true);
  expect(run.states.value).toBeNull();
  expect(notices.value).toMatchObject([{ key: 'page.errors.crash' }]);
  expect(await run.open(variants, { scene, pins, from: null })).toBe(true);
  expect(workers).toHaveLength(2);
});

test('what still waits when the reader leaves finds no new worker; what is asked after coming back does', async () => {
  vi.stubGlobal('cancelAnimationFrame', () => {});
  onTestFinished(() => void vi.unstubAllGlobals());
  const run = newRun();
  const leave = run.follow();
  const opened = [1, 2].map(() => run.open(variants, { scene, pins, from: null }));
  await Promise.resolve(); // the first one is at work
  leave();
  expect(await Promise.all(opened)).toEqual([false, false]);
  expect(workers.every(({ ended }) => ended)).toBe(true);
  expect(run.states.value).toBeNull();
  expect(notices.value).toEqual([]);
  expect(await run.open(variants, { scene, pins, from: null })).toBe(true);
  expect(workers.filter(({ ended }) => !ended)).toHaveLength(1);
});

test('a change overtaken by another before its turn is not made; curves go on with who they belong to', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  await run.run(2);
  const softer = variants.map((variant) => ({ ...variant, parameters: { ...variant.parameters, k: 500 } }));
  const refused = [{ ...variants[0], parameters: { ...usualParameters, k: -1 } }];
  const [overtaken, last] = [run.change(refused), run.change([softer[1], softer[0], variants[0]])];
  expect(await Promise.all([overtaken, last])).toEqual([true, true]);
  expect(notices.value).toEqual([]);
  expect(run.states.value).toHaveLength(3);
  // The equal one is found first; the others go on from those left, in order.
  expect(run.energies.value.map((curve) => curve.length)).toEqual([2, 0, 2]);
  await run.reset();
  expect(run.states.value).toHaveLength(3);
});

test('a refused change is said and leaves all as it was', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  expect(await run.change([{ ...variants[0], parameters: { ...usualParameters, k: -1 } }])).toBe(false);
  expect(notices.value).toMatchObject([{ key: 'page.errors.not_positive' }]);
  await run.reset();
  expect(run.states.value).toHaveLength(2);
});

test('distances are measured from the variant of reference', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  await run.run(3);
  expect(run.distances.value[0]).toEqual([{ time: 3 / 30, distance: 0 }]);
  expect(run.distances.value[1][0].distance).toBeGreaterThan(0);
  run.measureBy(1);
  expect(run.distances.value).toEqual([[], []]);
  await run.run(1);
  expect(run.distances.value[1]).toMatchObject([{ distance: 0 }]);
});

test('the same instant is one time step by all, with the errors of each', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  await run.run(3);
  await run.sameInstant(1);
  expect(run.step.value).toBe(4);
  const { leader, errors } = run.instant.value ?? { leader: null, errors: [] };
  expect(leader).toBe(1);
  expect(errors[0]?.objective).toBeGreaterThan(errors[1]?.objective ?? Number.POSITIVE_INFINITY);
});

test('the same instant starts from the motion that was wanted, and again when methods before it are gone', async () => {
  const run = newRun();
  await run.open(variants, { scene, pins, from: null });
  run.wantedLeader.value = 1;
  expect(run.leader.value).toBe(1);
  await run.sameInstant(run.leader.value);
  expect(run.instant.value?.leader).toBe(1);
  expect(await run.change(variants.slice(1))).toBe(true);
  expect(run.leader.value).toBe(0);
});
