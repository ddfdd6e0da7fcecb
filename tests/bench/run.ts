// `npm run bench`: how long an iteration takes natively, in code made for this machine (the course's algorithm, tests/bench/native), and in
// WebAssembly (in this Node) on both paths.
import { writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { loadSolver } from '../../web/headless/load_solver.ts';
import { runScene } from '../../web/headless/run_scene.ts';
import { sceneParameters } from '../../web/src/solver/scene_parameters.ts';
import { openScene } from '../support/open_scene.ts';
import { buildReference, runReference } from './native_reference.ts';

/** Time steps a round: enough that the small scenes, too, run in optimised code most of the time. */
const scenes = { net: 4000, tower: 800, flag: 60, skirt: 30 };
/** All take turns: a machine that slows down meanwhile slows all of them. */
const rounds = 3;
/** Of each round's steps, those before this share are not counted: cold memory, and wasm that is not yet optimised. */
const warmUp = 0.5;

function median(values: number[]): number {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
}

const rounded = (value: number) => Number(value.toPrecision(3));

const results = [];
buildReference();
const solver = await loadSolver();
for (const [name, steps] of Object.entries(scenes)) {
  const scene = await openScene(name);
  const parameters = sceneParameters(scene);
  const warm = (stepTimes: number[]) => stepTimes.slice(Math.floor(warmUp * steps));
  const native: number[] = []; // ms a step, as are those below
  const plain: number[] = [];
  const fast: number[] = [];
  for (let round = 0; round < rounds; round++) {
    native.push(...warm(runReference('reference_fast', scene, parameters, steps).stepTimes));
    plain.push(...warm(runScene(solver, scene, { ...parameters, path: 'plain' }, steps).stepTimes));
    fast.push(...warm(runScene(solver, scene, { ...parameters, path: 'fast' }, steps).stepTimes));
  }
  const { iterations } = parameters;
  const perIteration = (stepTimes: number[]) => rounded((1000 * median(stepTimes)) / iterations); // µs
  results.push({
    scene: name,
    vertices: scene.V.length / 3,
    springs: scene.E.length / 2,
    iterations,
    'native µs': perIteration(native),
    'wasm plain µs': perIteration(plain),
    'wasm fast µs': perIteration(fast),
    'native / plain': rounded(median(native) / median(plain)),
    'native / fast': rounded(median(native) / median(fast)),
  });
}

console.table(results);
const report = { cpu: cpus()[0].model, node: process.version, rounds, scenes, results };
writeFileSync(join(import.meta.dirname, 'results.json'), `${JSON.stringify(report, null, 2)}\n`);
