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
      run: async (...request: Parameters<SideBySideSession['run']>) => session.run(...request),
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
