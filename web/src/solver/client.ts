import { wrap } from 'comlink';
import type {
  Elimination,
  EliminationStep,
  EliminationStepRequest,
  LinearlyImplicitMatrices,
  Matrices,
  StorageComparison,
} from './matrices.ts';
import type { Ordering } from './module.ts';
import type {
  Checkpoint,
  Inspection,
  MethodRequest,
  MethodRun,
  Opened,
  Outcome,
  Problem,
  Progress,
  ProgressMessage,
  Reply,
  Request,
  SolverService,
} from './protocol.ts';

/** The solver trapped, hung or vanished and was replaced; what the page last showed is restored. */
export class SolverCrash extends Error {
  override name = 'SolverCrash';
}

/** The request was given up by cancel(); what the page last showed is restored. */
export class SolverCancelled extends Error {
  override name = 'SolverCancelled';
}

/** A worker that shows no sign of life for so long counts as hung. The plain path, which shows none, takes half of it for the largest scenes. */
const patience_ms = 60_000;

export interface SolverClientOptions {
  createWorker: () => Worker;
  /** Asked for once a worker is needed. */
  wasmBinary: () => Promise<ArrayBuffer>;
  /** Called while a request takes long, restoring included; never after its end. */
  onProgress: (progress: Progress) => void;
}

/**
 * The page's handle on the solver's worker. Keeps what is needed to replace the worker at any moment – the problem and the last checkpoint – so
 * that a crash costs the request that caused it and nothing else. One request at a time: callers await the reply.
 */
export class SolverClient {
  private worker: Worker | null = null;
  private service: SolverService | null = null;
  /** Ends the wait for the worker's answer; null while nothing is awaited. */
  private giveUp: ((reason: Error) => void) | null = null;
  private patience: ReturnType<typeof setTimeout> | undefined;
  private ended = false;
  private lastGood: { problem: Problem; request: Request; checkpoint: Checkpoint } | null = null;

  private readonly options: SolverClientOptions;

  constructor(options: SolverClientOptions) {
    this.options = options;
  }

  /** Starts the worker. Rejects when the module does not compile here. */
  async start(): Promise<void> {
    await this.ready();
  }

  /** Opens a problem, at rest or where `from` says, and runs the request there. On failure the one open before stays. Throws SolverCrash or SolverCancelled. */
  async open(problem: Problem, request: Request, from: Checkpoint | null = null): Promise<Outcome<Opened>> {
    const outcome = await this.guarded((service) => service.open(problem, request, from));
    if (outcome.ok) this.lastGood = { problem, request, checkpoint: outcome.value.checkpoint };
    else this.stop(); // it may have been refused halfway: the next call restores what was open before
    return outcome;
  }

  /** Runs a request on the open problem. Throws SolverCrash or SolverCancelled after restoring the last good state in a new worker. */
  async run(request: Request): Promise<Outcome<Reply>> {
    const outcome = await this.guarded((service) => service.run(request));
    if (outcome.ok && this.lastGood)
      this.lastGood = { problem: this.lastGood.problem, request, checkpoint: outcome.value.checkpoint };
    return outcome;
  }

  /** The present time step by another method. Throws SolverCrash or SolverCancelled after restoring the last good state in a new worker. */
  async compare(request: MethodRequest): Promise<Outcome<MethodRun>> {
    return this.guarded((service) => service.compare(request));
  }

  /** Looks at the open problem. Throws SolverCrash or SolverCancelled. */
  inspect(points: readonly Float64Array[]): Promise<Inspection> {
    return this.guarded((service) => service.inspect(points));
  }

  /** What the matrix room shows of the open problem; each leaves the solver where it stands. Throws SolverCrash or SolverCancelled. */
  matrices(): Promise<Matrices> {
    return this.guarded((service) => service.matrices());
  }

  linearlyImplicit(): Promise<LinearlyImplicitMatrices> {
    return this.guarded((service) => service.linearlyImplicit());
  }

  elimination(ordering: Ordering): Promise<Elimination> {
    return this.guarded((service) => service.elimination(ordering));
  }

  eliminationStep(request: EliminationStepRequest): Promise<Outcome<EliminationStep>> {
    return this.guarded((service) => service.eliminationStep(request));
  }

  compareStorage(): Promise<StorageComparison> {
    return this.guarded((service) => service.compareStorage());
  }

  /** Gives up the request in flight, if there is one. Its worker is busy and hears nothing, so it is ended and replaced. */
  cancel(): void {
    this.giveUp?.(new SolverCancelled());
  }

  /** Ends the worker, and with it the request in flight, which is cancelled. Nothing can be asked afterwards. */
  end(): void {
    this.ended = true;
    this.cancel();
    this.stop();
  }

  private async guarded<T>(call: (service: SolverService) => Promise<T>): Promise<T> {
    try {
      return await this.untilFailure(call(await this.ready()));
    } catch (reason) {
      this.stop();
      await this.ready().catch(() => {}); // the next call tries again
      if (reason instanceof SolverCancelled) throw reason;
      throw new SolverCrash(reason instanceof Error ? reason.message : String(reason));
    }
  }

  /** Rejects when the request is given up, where comlink alone would wait for ever. */
  private async untilFailure<T>(reply: Promise<T>): Promise<T> {
    const failure = new Promise<never>((_, reject) => {
      this.giveUp = reject;
    });
    this.signOfLife();
    try {
      return await Promise.race([reply, failure]);
    } finally {
      clearTimeout(this.patience);
      this.giveUp = null;
    }
  }

  private signOfLife(): void {
    clearTimeout(this.patience);
    this.patience = setTimeout(
      () => this.giveUp?.(new Error(`no sign of life in ${patience_ms / 1000} s`)),
      patience_ms,
    );
  }

  /** The service, in a new worker if there is none. */
  private async ready(): Promise<SolverService> {
    try {
      this.service ??= await this.newService();
      return this.service;
    } catch (reason) {
      this.stop();
      throw reason;
    }
  }

  /** In a new worker, with the last good state open in it. */
  private async newService(): Promise<SolverService> {
    if (this.ended) throw new SolverCancelled();
    this.worker = this.startWorker();
    // Every method of the service is asynchronous already; comlink's Remote type would split its unions.
    const service = wrap(this.worker) as unknown as SolverService;
    const wasmBinary = await this.options.wasmBinary();
    if (this.ended) throw new SolverCancelled(); // meanwhile, and the worker with it
    await this.untilFailure(service.start(wasmBinary));
    if (this.lastGood) {
      const { problem, request, checkpoint } = this.lastGood;
      const restored: Request = { ...request, command: { kind: 'stay' }, wholeTrace: false, profile: false };
      const outcome = await this.untilFailure(service.open(problem, restored, checkpoint));
      if (!outcome.ok) throw new Error(`the last good state was refused: ${outcome.status.code}`);
    }
    return service;
  }

  private startWorker(): Worker {
    const worker = this.options.createWorker();
    worker.addEventListener('error', (event) => this.giveUp?.(new Error(event.message || 'the worker stopped')));
    worker.addEventListener('message', ({ data }: MessageEvent<Partial<ProgressMessage>>) => {
      if (worker !== this.worker || !data.progress) return; // what an ended worker had posted may still arrive
      this.signOfLife();
      this.options.onProgress(data.progress);
    });
    return worker;
  }

  private stop(): void {
    this.worker?.terminate();
    this.worker = null;
    this.service = null;
  }
}
