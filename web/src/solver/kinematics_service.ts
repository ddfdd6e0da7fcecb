import { type Followed, followTargets } from './follow_targets.ts';
import { countIterations, type IterationCounts } from './ik_counts.ts';
import { type Reach, reachByAll } from './ik_reach.ts';
import { type Sweep, type SweepStart, sweep } from './ik_sweep.ts';
import type { IkAnswer, IkMethod, IkTask } from './inverse_kinematics.ts';
import type { SolverModule } from './module.ts';
import type { Outcome } from './protocol.ts';

/** What a worker of its own finds out about chains of joints. */
export interface KinematicsService {
  /** Compiles the module. Call once, before anything else. */
  start(wasmBinary: ArrayBuffer): Promise<void>;
  solve(task: IkTask): Promise<Outcome<IkAnswer>>;
  /** `targets` #T×3, m. */
  follow(task: IkTask, targets: Float64Array): Promise<Outcome<Followed>>;
  /** What the lab's questions ask: ik_reach.ts, ik_counts.ts and ik_sweep.ts say what for. */
  reachByAll(task: IkTask, beside: Float64Array): Promise<Outcome<Record<IkMethod, Reach>>>;
  countIterations(task: IkTask, curves: readonly Float64Array[]): Promise<Outcome<IterationCounts[]>>;
  sweep(task: IkTask, targets: Float64Array, start: SweepStart): Promise<Outcome<Sweep>>;
}

/** The service on a module; `createSolver` compiles it. */
export function kinematicsService(
  createSolver: (wasmBinary: ArrayBuffer) => Promise<Pick<SolverModule, 'inverse_kinematics'>>,
): KinematicsService {
  let solver: Pick<SolverModule, 'inverse_kinematics'>;
  return {
    async start(wasmBinary) {
      solver = await createSolver(wasmBinary);
    },
    async solve(task) {
      const { status, answer } = solver.inverse_kinematics(task);
      return status.code === 'ok' ? { ok: true, value: answer } : { ok: false, status };
    },
    async follow(task, targets) {
      return followTargets(solver, task, targets);
    },
    async reachByAll(task, beside) {
      return reachByAll(solver, task, beside);
    },
    async countIterations(task, curves) {
      return countIterations(solver, task, curves, () => performance.now());
    },
    async sweep(task, targets, start) {
      return sweep(solver, task, targets, start);
    },
  };
}
