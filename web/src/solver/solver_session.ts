import { compareMethod } from './compare_method.ts';
import { compareStorage } from './compare_storage.ts';
import { readElimination, readEliminationStep } from './eliminations.ts';
import type { Frame } from './frame.ts';
import type {
  Elimination,
  EliminationStep,
  EliminationStepRequest,
  LinearlyImplicitMatrices,
  Matrices,
  StorageComparison,
} from './matrices.ts';
import { measureIteration } from './measure_iteration.ts';
import type { Ordering, Simulation, SolverModule, Status } from './module.ts';
import type {
  Checkpoint,
  Command,
  Inspection,
  MethodRequest,
  MethodRun,
  Opened,
  Outcome,
  Problem,
  Progress,
  Reply,
  Request,
} from './protocol.ts';
import { readFrame } from './read_frame.ts';
import { readLinearlyImplicit } from './read_linearly_implicit.ts';
import { readMatrices } from './read_matrices.ts';

const ok: Status = { code: 'ok', field: '', index: -1, value: 0, limit: 0 };

/** Owns one Simulation of the module and answers requests. Runs in the worker; knows neither worker nor page. */
export class SolverSession {
  private readonly simulation: Simulation;

  constructor(module: SolverModule, onProgress: (progress: Progress) => void) {
    this.simulation = new module.Simulation();
    this.simulation.set_progress((stage, fraction) =>
      onProgress({ stage, fraction, vertices: this.simulation.vertex_count() }),
    );
  }

  open(problem: Problem, request: Request, from: Checkpoint | null): Outcome<Opened> {
    const started = performance.now();
    const { parameters, pins } = request;
    let status = this.simulation.set_scene(problem.V, problem.E, problem.m, pins.pinned, parameters);
    if (status.code === 'ok') status = this.simulation.set_pins(pins.pinned, pins.targets);
    if (status.code === 'ok' && from)
      status = this.simulation.set_state(from.step, from.p_curr, from.p_prev, from.half_step);
    if (status.code === 'ok') status = this.move(request.command);
    const outcome = this.reply(status, request, started);
    return outcome.ok ? { ok: true, value: { ...outcome.value, r: this.simulation.r().slice() } } : outcome;
  }

  run(request: Request): Outcome<Reply> {
    const started = performance.now();
    let status = this.simulation.set_parameters(request.parameters);
    if (status.code === 'ok') status = this.simulation.set_pins(request.pins.pinned, request.pins.targets);
    if (status.code === 'ok') status = this.move(request.command);
    return this.reply(status, request, started);
  }

  compare(request: MethodRequest): Outcome<MethodRun> {
    return compareMethod(this.simulation, request);
  }

  inspect(points: readonly Float64Array[]): Inspection {
    const s = this.simulation;
    return {
      p_curr: s.p_curr().slice(),
      p_prev: s.p_prev().slice(),
      m: s.m().slice(),
      A: s.A(),
      M: s.M(),
      C: s.C(),
      Q: s.Q(),
      equations: Array.from({ length: s.vertex_count() }, (_, vertex) => ({ vertex, ...s.probe_vertex(vertex) })),
      explicitStep: s.explicit_step().slice(),
      iterates: this.iterates(),
      evaluations: points.map((p) => ({ ...s.objective_at(p), gradient: s.gradient_at(p).slice() })),
    };
  }

  matrices(): Matrices {
    return readMatrices(this.simulation);
  }

  linearlyImplicit(): LinearlyImplicitMatrices {
    return readLinearlyImplicit(this.simulation);
  }

  elimination(ordering: Ordering): Elimination {
    return readElimination(this.simulation, ordering);
  }

  eliminationStep(request: EliminationStepRequest): Outcome<EliminationStep> {
    return readEliminationStep(this.simulation, request);
  }

  compareStorage(): StorageComparison {
    return compareStorage(this.simulation);
  }

  private iterates(): Float64Array[] {
    const s = this.simulation;
    const here = s.half_step();
    const iterates: Float64Array[] = [];
    for (let half_step = 0; half_step < s.last_half_step(); half_step += 2) {
      s.seek(half_step);
      iterates.push(s.p().slice());
    }
    s.seek(here);
    return iterates;
  }

  private move(command: Command): Status {
    const s = this.simulation;
    const here = s.half_step();
    switch (command.kind) {
      case 'stay':
        return s.seek(here);
      case 'seek':
        return s.seek(command.half_step);
      case 'next_half_step':
        return here < s.last_half_step() ? s.seek(here + 1) : s.next_step();
      case 'previous_half_step':
        if (here > 0) return s.seek(here - 1);
        s.previous_step();
        return ok;
      case 'next_step':
        return s.step();
      case 'previous_step':
        s.previous_step();
        return ok;
      case 'go_to_step':
        return this.goToStep(command.step);
      case 'reset':
        return s.reset();
      case 'play': {
        for (let step = 0; step < command.steps; step++) {
          const status = s.step();
          if (status.code !== 'ok') return status;
        }
        return ok;
      }
    }
  }

  private goToStep(step: number): Status {
    const s = this.simulation;
    if (step < s.step_number()) s.back_to(Math.max(step, s.step_number() - s.remembered_steps()));
    while (s.step_number() < step) {
      const status = s.step(); // the first one completes the time step that the cursor stands in
      if (status.code !== 'ok') return status;
    }
    return s.seek(s.last_half_step());
  }

  private reply(status: Status, request: Request, started: number): Outcome<Reply> {
    if (status.code !== 'ok') return { ok: false, status };
    const s = this.simulation;
    const playing = request.command.kind === 'play';
    if (request.wholeTrace) {
      const here = s.half_step();
      const traced = s.seek(s.last_half_step());
      if (traced.code !== 'ok') return { ok: false, status: traced };
      s.seek(here);
    }
    const frame = readFrame(s, {
      pinned: request.pins.pinned,
      selectedVertex: request.selectedVertex,
      events: !playing,
    });
    frame.milliseconds = performance.now() - started;
    if (request.profile) frame.profile = measureIteration(s);
    return { ok: true, value: { frame, checkpoint: checkpointOf(frame) } };
  }
}

/** With the frame's own arrays: nobody changes them, and the worker sends each array once. */
function checkpointOf({ step, half_step, pCurr, pPrev }: Frame): Checkpoint {
  return { step, half_step, p_curr: pCurr, p_prev: pPrev };
}
