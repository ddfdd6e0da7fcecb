// `npm run bench`: how much longer a time step takes in WebAssembly (in this Node) than in native code made for this machine.
import { writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { loadSolver } from '../../web/headless/load_solver.ts';
import { runScene } from '../../web/headless/run_scene.ts';
import { sceneParameters } from '../../web/src/solver/scene_parameters.ts';
import { openScene } from '../support/open_scene.ts';
import { buildReference, runReference } from './native_reference.ts';

const scenes = ['net', 'tower', 'flag', 'skirt'];
/** Native and wasm take turns: a machine that slows down meanwhile slows both. */
const rounds = 3;
const stepsPerRound = 10;
/** Steps before those: cold memory, and wasm that is not yet optimised. */
const warmUpSteps = 2;

function median(values: number[]): number {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
}

const rounded = (value: number) => Number(value.toPrecision(3));

const results = [];
buildReference();
const solver = await loadSolver();
for (const name of scenes) {
  const scene = await openScene(name);
  const parameters = sceneParameters(scene);
  const native: number[] = []; // ms
  const wasm: number[] = []; // ms
  for (let round = 0; round < rounds; round++) {
    const steps = warmUpSteps + stepsPerRound;
    native.push(...runReference('reference_fast', scene, parameters, steps).stepTimes.slice(warmUpSteps));
    wasm.push(...runScene(solver, scene, parameters, steps).stepTimes.slice(warmUpSteps));
  }
  results.push({
    scene: name,
    vertices: scene.V.length / 3,
    springs: scene.E.length / 2,
    iterations: parameters.iterations,
    nativeMilliseconds: rounded(median(native)),
    wasmMilliseconds: rounded(median(wasm)),
    ratio: rounded(median(wasm) / median(native)),
  });
}

console.table(results);
const report = { cpu: cpus()[0].model, node: process.version, rounds, stepsPerRound, results };
writeFileSync(join(import.meta.dirname, 'results.json'), `${JSON.stringify(report, null, 2)}\n`);
