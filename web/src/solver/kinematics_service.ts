import { type Followed, followTargets } from './follow_targets.ts';
import type { IkAnswer, IkTask } from './inverse_kinematics.ts';
import type { SolverModule } from './module.ts';
import type { Outcome } from './protocol.ts';

/** What a worker of its own finds out about chains of joints. */
export interface KinematicsService {
  /** Compiles the module. Call once, before anything else. */
  start(wasmBinary: ArrayBuffer): Promise<void>;
  solve(task: IkTask): Promise<Outcome<IkAnswer>>;
  /** `targets` #T×3, m. */
  follow(task: IkTask, targets: Float64Array): Promise<Outcome<Followed>>;
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
  };
}
