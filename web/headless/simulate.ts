import { basename, dirname } from 'node:path';
import { loadScene } from '../src/scene/load_scene.ts';
import { describeSceneError, isSceneError } from '../src/scene/scene_error.ts';
import { sceneParameters } from '../src/solver/scene_parameters.ts';
import { folderSource } from './folder_source.ts';
import { loadSolver } from './load_solver.ts';
import { type Arguments, help, parseArguments } from './parse_arguments.ts';
import { runScene } from './run_scene.ts';
import { UsageError } from './usage_error.ts';

try {
  const parsed = parseArguments(process.argv.slice(2));
  process.stdout.write(parsed ? await simulate(parsed) : help);
} catch (error) {
  if (!(error instanceof UsageError)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 2;
}

/** What the command prints. */
async function simulate({
  scene: path,
  steps,
  overrides,
  path: how,
  storage,
  format,
  substeps,
}: Arguments): Promise<string> {
  const scene = await loadScene(basename(path), folderSource(dirname(path)));
  if (isSceneError(scene)) throw new UsageError(describeSceneError(scene));

  const parameters = { ...sceneParameters(scene), ...overrides, path: how, storage };
  const run = runScene(await loadSolver(), scene, parameters, { steps, substeps });

  const positions = rowsOf(run.p);
  if (format === 'csv') {
    return ['vertex,x,y,z', ...positions.map((point, i) => [i + 1, ...point].join(',')), ''].join('\n');
  }
  const result = {
    scene: scene.name,
    vertexCount: positions.length,
    springCount: scene.E.length / 2,
    method: parameters.method,
    path: how,
    storage,
    steps,
    substeps,
    iterations: parameters.iterations,
    deltaT: parameters.delta_t,
    damping: parameters.damping, // N s/m
    positions, // m
    velocities: rowsOf(run.velocity), // m/s
    objective: run.objective, // J, one a step
    energy: run.energy, // J, one a step
    iterationsMade: run.iterationsMade, // one a step
    stopReason: run.stopReason,
    milliseconds: {
      precompute: run.precompute,
      step: { min: Math.min(...run.stepTimes), median: median(run.stepTimes) },
    },
  };
  return `${JSON.stringify(result)}\n`;
}

function rowsOf(points: Float64Array): number[][] {
  return Array.from({ length: points.length / 3 }, (_, i) => [...points.subarray(3 * i, 3 * i + 3)]);
}

function median(values: number[]): number {
  const sorted = values.toSorted((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}
