import type { Scene } from '../../web/src/scene/scene.ts';
import type { SolverModule } from '../../web/src/solver/module.ts';
import { benchParameters } from './bench_parameters.ts';
import { runReference } from './native_reference.ts';
import { runModule } from './run_module.ts';
import { median } from './statistics.ts';
import type { TimedRun } from './timed_run.ts';

/** ms natively and in WebAssembly on both paths, and how many times faster than native those are. */
export interface Comparison {
  native: number;
  plain: number;
  fast: number;
  'native / plain': number;
  'native / fast': number;
}

export interface SceneTimes {
  vertices: number;
  springs: number;
  /** Of L as the native program has it: with pinned vertices in it, in Eigen's order of minimum degree. */
  nonzeros: number;
  iteration: Comparison;
  precompute: Comparison;
  refactorise: Comparison;
}

/** All take turns: a machine that slows down meanwhile slows all of them. */
export const rounds = 3;
/** Vertices times time steps of a round: enough that the small scenes, too, run in optimised code most of the time. */
const vertexSteps = 2e5;
/** Of each round's steps, those before this share are not counted: cold memory, and wasm that is not yet optimised. */
const warmUp = 0.5;

/** Medians over the rounds. */
export function pairedRounds(solver: SolverModule, scene: Scene): SceneTimes {
  const parameters = benchParameters(scene);
  const vertices = scene.V.length / 3;
  const steps = Math.ceil(vertexSteps / vertices);
  const turns = Array.from({ length: rounds }, () => ({
    native: runReference('reference_fast', scene, parameters, steps),
    plain: runModule(solver, scene, { ...parameters, path: 'plain' }, steps),
    fast: runModule(solver, scene, { ...parameters, path: 'fast' }, steps),
  }));
  const compare = (time: (run: TimedRun) => number): Comparison => {
    const [native, plain, fast] = (['native', 'plain', 'fast'] as const).map((who) =>
      turns.map((turn) => time(turn[who])),
    );
    return {
      native: median(native),
      plain: median(plain),
      fast: median(fast),
      'native / plain': median(native.map((time, round) => time / plain[round])),
      'native / fast': median(native.map((time, round) => time / fast[round])),
    };
  };
  return {
    vertices,
    springs: scene.E.length / 2,
    nonzeros: turns[0].native.nonzeros,
    iteration: compare(({ stepTimes }) => median(stepTimes.slice(warmUp * steps)) / parameters.iterations),
    precompute: compare(({ precompute }) => precompute),
    refactorise: compare(({ refactorise }) => refactorise),
  };
}
