import type { Scene } from '../../web/src/scene/scene.ts';
import {
  type Minimiser,
  minimisers,
  type Parameters,
  type Simulation,
  type SolverModule,
} from '../../web/src/solver/module.ts';
import { benchParameters } from './bench_parameters.ts';
import { type Instant, lastStep, playThrough, restore } from './instants.ts';
import { decrease, iterationsNeeded } from './iterations_needed.ts';
import { milliseconds, typical } from './milliseconds.ts';
import { runReference } from './native_reference.ts';
import { rounds } from './paired_rounds.ts';
import { median, sum } from './statistics.ts';
import { succeed } from './succeed.ts';

/** What a method of the fast path takes until E is as low as the native program's iterations bring it. */
export interface MethodTime {
  method: Minimiser;
  /** The median over the instants. */
  iterations: number;
  /** ms: the sum over the instants, natively and by this method. */
  native: number;
  time: number;
  'native / method': number;
}

export interface SameAccuracy {
  /** m: the most by which a coordinate on the fast path differs from the native program's after the last instant. */
  difference: number;
  /** Those that get there at every instant. */
  methods: MethodTime[];
}

/** Every method at several instants of a motion that starts from rest; times are medians over the rounds. */
export function sameAccuracy(solver: SolverModule, scene: Scene): SameAccuracy {
  const parameters = benchParameters(scene);
  const simulation = new solver.Simulation();
  try {
    succeed(simulation.set_scene(scene.V, scene.E, scene.m, scene.pinned, parameters));
    const instants = playThrough(simulation);
    const p = simulation.p().slice(); // #V×3, m
    const plans = planMethods(simulation, instants, parameters.iterations);
    const turns = Array.from({ length: rounds }, () => ({
      native: runReference('reference_fast', scene, parameters, lastStep),
      times: plans.map((plan) => planTime(simulation, instants, plan, parameters)), // ms
    }));
    const native = turns.map((turn) => instants.length * median(turn.native.stepTimes));
    return {
      difference: p.reduce((largest, x, c) => Math.max(largest, Math.abs(x - turns[0].native.p[c])), 0),
      methods: plans.map(({ method, needed }, i) => ({
        method,
        iterations: median(needed),
        native: median(native),
        time: median(turns.map(({ times }) => times[i])),
        'native / method': median(turns.map(({ times }, round) => native[round] / times[i])),
      })),
    };
  } finally {
    simulation.delete();
  }
}

interface Plan {
  method: Minimiser;
  /** Iterations at each instant. */
  needed: number[];
}

function planMethods(simulation: Simulation, instants: Instant[], iterations: number): Plan[] {
  const atEach = (figure: (i: number) => number) =>
    instants.map((instant, i) => {
      restore(simulation, instant);
      return figure(i);
    });
  const targets = atEach(() => decrease(simulation, 'local-global', iterations)); // J
  return minimisers
    .map((method) => ({ method, needed: atEach((i) => iterationsNeeded(simulation, method, targets[i])) }))
    .filter(({ needed }) => needed.every(Number.isFinite));
}

/** ms: the sum over the instants, of time steps that record nothing. */
function planTime(simulation: Simulation, instants: Instant[], plan: Plan, parameters: Parameters): number {
  const times = instants.map((instant, i) => {
    succeed(simulation.set_parameters({ ...parameters, method: plan.method, iterations: plan.needed[i] }));
    return typical(() => {
      restore(simulation, instant);
      return milliseconds(() => succeed(simulation.step()));
    });
  });
  return sum(times);
}
