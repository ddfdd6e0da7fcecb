import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { beforeAll, expect, test } from 'vitest';
import { methods, type Parameters } from '../../web/src/solver/module.ts';
import { openScene } from '../support/open_scene.ts';
import { expectOk, openSimulation } from '../support/open_simulation.ts';
import { net, type SmallScene, usualParameters } from '../support/small_scenes.ts';

const wasm = join(import.meta.dirname, '../../wasm');

beforeAll(() => {
  execFileSync(process.execPath, [join(wasm, 'build.mjs'), 'native'], { stdio: 'inherit' });
}, 600_000); // compiles everything on a fresh machine

function runNatively({ V, E, m, pinned }: SmallScene, parameters: Parameters, steps: number): number[] {
  const { k, delta_t, w, mass_scale, iterations, gravity, path, storage, method } = parameters;
  const counts = [m.length, E.length / 2, pinned.length, steps];
  const settings = [
    k,
    delta_t,
    w,
    mass_scale,
    iterations,
    gravity,
    Number(storage === 'dense'),
    Number(path === 'fast'),
    methods.indexOf(method),
  ];
  const input = [counts, settings, V, E, m, pinned].map((values) => values.join(' ')).join('\n');
  const output = execFileSync(join(wasm, 'build/native/run_scene'), { input, encoding: 'utf8' });
  return output.trim().split('\n').map(Number);
}

function runInWebAssembly(scene: SmallScene, parameters: Parameters, steps: number): number[] {
  const simulation = openSimulation(scene, parameters);
  for (let step = 0; step < steps; step++) expectOk(simulation.step());
  return [...simulation.p()];
}

// Wind is left out: its sines and cosines are the C library's.
test.each(['sparse', 'dense'] as const)('a net ends in the same bits natively and in WebAssembly: %s', (storage) => {
  const parameters = { ...usualParameters, storage };
  expect(runInWebAssembly(net(6), parameters, 20)).toEqual(runNatively(net(6), parameters, 20));
});

test('and so do net and tower on the fast path', async () => {
  const tower = await openScene('tower');
  for (const [scene, k] of [
    [net(6), 1e3],
    [tower, tower.k],
  ] as const) {
    const parameters = { ...usualParameters, k, path: 'fast' } as const;
    expect(runInWebAssembly(scene, parameters, 20)).toEqual(runNatively(scene, parameters, 20));
  }
});

test.each(['chebyshev', 'anderson', 'lbfgs'] as const)('and so does a net by %s, on either path', (method) => {
  for (const path of ['fast', 'plain'] as const) {
    const parameters = { ...usualParameters, method, path };
    expect(runInWebAssembly(net(6), parameters, 20)).toEqual(runNatively(net(6), parameters, 20));
  }
});

test('and so does the tower, dense, large enough for products in blocks', async () => {
  const tower = await openScene('tower');
  const parameters = { ...usualParameters, k: tower.k, delta_t: tower.delta_t, storage: 'dense' } as const;
  expect(runInWebAssembly(tower, parameters, 3)).toEqual(runNatively(tower, parameters, 3));
});
