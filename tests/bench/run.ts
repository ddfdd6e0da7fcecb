// `npm run bench`: what time steps cost natively, in code made for this machine (the course's algorithm, tests/bench/native), and in WebAssembly, in
// this Node. docs/performance.md says what is measured and what came of it.
import { readFile, writeFile } from 'node:fs/promises';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { loadSolver } from '../../web/headless/load_solver.ts';
import { openScene } from '../support/open_scene.ts';
import { sceneFromRule } from '../support/scene_from_rule.ts';
import { tetrahedralBlock } from '../support/tetrahedral_block.ts';
import { halfSteps } from './half_steps.ts';
import { integratorTimes } from './integrators.ts';
import { buildReference, measureBandwidth } from './native_reference.ts';
import { pairedRounds } from './paired_rounds.ts';
import { printTables, type Report, rounded } from './report.ts';
import { sameAccuracy } from './same_accuracy.ts';
import { sizeSweep } from './size_sweep.ts';

buildReference();
const solver = await loadSolver();
const binary = await readFile(fileURLToPath(import.meta.resolve('#wasm/solver.wasm')));

const scenes: Report['scenes'] = [];
for (const scene of [
  await openScene('net'),
  await openScene('tower'),
  await openScene('flag'),
  await openScene('skirt'),
  await sceneFromRule(tetrahedralBlock()),
]) {
  scenes.push({
    scene: scene.name,
    ...pairedRounds(solver, scene),
    halfSteps: halfSteps(solver, scene),
    sameAccuracy: sameAccuracy(solver, scene),
  });
}

const report = rounded({
  machine: { cpu: cpus()[0].model, node: process.version, bandwidth: measureBandwidth() },
  wasm: { raw: binary.length, gzip: gzipSync(binary, { level: 9 }).length },
  scenes,
  sizes: await sizeSweep(solver),
  integrators: await Promise.all(
    ['cloth', 'rabbit', 'rabbit-fine'].map(async (name) => integratorTimes(solver, await openScene(name))),
  ),
});
printTables(report);
await writeFile(join(import.meta.dirname, 'results.json'), `${JSON.stringify(report, null, 2)}\n`);
