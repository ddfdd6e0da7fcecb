import { type Remote, wrap } from 'comlink';
import { SolverCrash } from '../solver/client.ts';
import { notifyOf } from './explanation.ts';
import { Obstacle } from './obstacle.ts';
import { fetchSolver } from './start_solver.ts';

interface Startable {
  /** Compiles the module. */
  start(wasmBinary: ArrayBuffer): Promise<void>;
}

/** What is hired: a worker, what it can be asked, and the end of every wait for an answer that will not come. */
interface Hired<Service> {
  worker: Worker;
  service: Promise<Remote<Service>>;
  lost: Promise<never>;
  lose: (reason: Error) => void;
}

/** A worker with a service: hired when it is first asked, asked one thing after the other, replaced after a failure. */
export class Crew<Service extends Startable> {
  private readonly createWorker: () => Worker;
  private readonly wasmBinary: () => Promise<ArrayBuffer>;
  private readonly onEnd: () => void;
  private hired: Hired<Service> | null = null;
  /** Requests take turns. */
  private last: Promise<unknown> = Promise.resolve();
  private waiting = 0;
  /** How often the reader has left. What was asked before is not to find a new worker afterwards, which nobody would end. */
  private departures = 0;

  /** `onEnd` hears that whatever the worker held is gone. */
  constructor(
    createWorker: () => Worker,
    onEnd: () => void = () => {},
    wasmBinary: () => Promise<ArrayBuffer> = fetchSolver,
  ) {
    this.createWorker = createWorker;
    this.onEnd = onEnd;
    this.wasmBinary = wasmBinary;
  }

  /** How many requests have no answer yet. */
  get queue(): number {
    return this.waiting;
  }

  /** Null when there was no answer, after a word about it unless the reader has left; the next request finds a new worker. */
  ask<T>(request: (service: Remote<Service>) => Promise<T>): Promise<T | null> {
    this.waiting += 1;
    const { departures } = this;
    const turn = this.last.then(() => this.askNow(request, departures));
    this.last = turn;
    return turn;
  }

  /** The reader leaves: the worker ends, and what waits gets no answer. */
  leave(): void {
    this.departures += 1;
    this.end();
  }

  private async askNow<T>(request: (service: Remote<Service>) => Promise<T>, departures: number): Promise<T | null> {
    try {
      if (departures !== this.departures) return null;
      this.hired ??= this.hire();
      return await Promise.race([this.hired.service.then(request), this.hired.lost]);
    } catch (reason) {
      if (reason !== ended) notifyOf(reason instanceof Obstacle ? reason : new SolverCrash((reason as Error).message));
      this.end();
      return null;
    } finally {
      this.waiting -= 1;
    }
  }

  private hire(): Hired<Service> {
    let lose: Hired<Service>['lose'] = () => {};
    const lost = new Promise<never>((_, reject) => {
      lose = reject;
    });
    lost.catch(() => {}); // also where nothing is asked any more
    const worker = this.createWorker();
    worker.addEventListener('error', ({ message }) => lose(new Error(message)));
    const service = this.wasmBinary().then(async (wasmBinary) => {
      const remote = wrap<Service>(worker);
      await (remote as Remote<Startable>).start(wasmBinary);
      return remote;
    });
    return { worker, service, lost, lose };
  }

  private end(): void {
    this.hired?.lose(ended);
    this.hired?.worker.terminate();
    this.hired = null;
    this.onEnd();
  }
}

const ended = new Error('ended');
