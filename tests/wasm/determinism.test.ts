import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { beforeAll, expect, test } from 'vitest';
import { methods } from '../../web/src/solver/module.ts';
import { solver } from '../support/open_simulation.ts';
import { hashOf, type Run, runInNode, runs } from '../support/same_bits.ts';

const wasm = join(import.meta.dirname, '../../wasm');

beforeAll(() => {
  execFileSync(process.execPath, [join(wasm, 'build.mjs'), 'native'], { stdio: 'inherit' });
}, 600_000); // compiles everything on a fresh machine

function runNatively({ scene: { V, E, m, pinned }, parameters, steps }: Run): Float64Array {
  const { k, delta_t, w, mass_scale, iterations, method, gravity, path, storage } = parameters;
  const counts = [m.length, E.length / 2, pinned.length, steps];
  const choices = [Number(storage === 'dense'), Number(path === 'fast'), methods.indexOf(method)];
  const settings = [k, delta_t, w, mass_scale, iterations, gravity, ...choices];
  const input = [counts, settings, V, E, m, pinned].map((values) => values.join(' ')).join('\n');
  const output = execFileSync(join(wasm, 'build/native/run_scene'), { input, encoding: 'utf8' });
  return Float64Array.from(output.trim().split('\n'), Number);
}

test.each(runs)('the same bits natively and in Node: $name', { timeout: 120_000 }, (run) => {
  expect(hashOf(runInNode(solver, run))).toBe(hashOf(runNatively(run)));
});
