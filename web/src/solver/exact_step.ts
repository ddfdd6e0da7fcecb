import { farthest } from './farthest.ts';
import type { SolverModule, Status } from './module.ts';
import type { Pins, Problem, Pull } from './protocol.ts';
import { type Motion, type Variant, VariantRunner } from './variant_runner.ts';

/** How far positions are from p*: max_i ‖p_i − p*_i‖, m, and E(p) − E(p*), J. */
export interface StepError {
  distance: number;
  objective: number;
}

/** More than Newton's method takes from anywhere; it ends by itself where E falls no further. */
const enough = 1000;

/** p*, the minimiser of the E(p) of one time step, whoever else makes that step. Whoever makes it deletes it. */
export class ExactStep {
  /** Wall-clock, of finding p*. */
  milliseconds = 0;
  private readonly runner: VariantRunner;
  private p: Float64Array = new Float64Array();

  constructor(module: SolverModule, { parameters }: Variant) {
    const newton = { method: 'newton', iterations: enough, stop_gradient: 0, stop_decrease: 0, path: 'fast' } as const;
    this.runner = new VariantRunner(module, {
      parameters: { ...parameters, ...newton },
      substeps: 1,
      mistake: 'none',
    });
  }

  /** From a motion, in the time step of that number. */
  solve(problem: Problem, pins: Pins, pull: Pull | null, motion: Motion, step: number): Status {
    let status = this.runner.open(problem, pins);
    if (status.code === 'ok') status = this.runner.move(motion, step);
    if (status.code !== 'ok') return status;
    const started = performance.now();
    this.runner.run(pins, pull, step, 1);
    this.milliseconds = performance.now() - started;
    this.p = this.runner.p();
    return this.runner.failure?.status ?? status;
  }

  errorOf(p: Float64Array): StepError {
    return { distance: farthest(p, this.p), objective: this.runner.objective(p) - this.runner.objective(this.p) };
  }

  delete(): void {
    this.runner.delete();
  }
}
