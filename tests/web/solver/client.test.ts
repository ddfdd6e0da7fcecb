import { afterEach, describe, expect, it, vi } from 'vitest';
import { SolverCancelled, SolverClient, SolverCrash } from '../../../web/src/solver/client.ts';
import type {
  Checkpoint,
  Outcome,
  Problem,
  ProgressMessage,
  Reply,
  Request,
} from '../../../web/src/solver/protocol.ts';
import { PortWorker } from '../../support/port_worker.ts';

const problem: Problem = { V: new Float64Array(3), E: new Int32Array(0), m: Float64Array.of(1) };
const request = (k: number, kind: 'stay' | 'next_step' = 'stay') =>
  ({ parameters: { k }, command: { kind }, wholeTrace: false }) as unknown as Request;

/** Whether new workers die as soon as a problem is opened in them. */
let dying = false;

/** Whether the solver's file can be had. */
let online = true;

/**
 * Each "worker" answers with the number of the step it stands at, refuses k = 0 once the problem is open in it, dies of k = 13 as a trapped module
 * does, and works for ever on k = 99.
 */
class FakeWorker extends PortWorker {
  readonly opened: { from: Checkpoint | null; request: Request }[] = [];
  private step = 0;

  constructor() {
    super();
    this.serve({
      start: async () => {},
      open: async (_: Problem, asked: Request, from: Checkpoint | null) => {
        if (dying) throw new WebAssembly.RuntimeError('out of memory');
        this.opened.push({ from, request: asked });
        this.step = from?.step ?? 1;
        return asked.parameters.k === 0 ? { ok: false, status: { code: 'not_positive' } } : this.reply();
      },
      run: async (asked: Request) => {
        if (asked.parameters.k === 13) throw new WebAssembly.RuntimeError('unreachable');
        if (asked.parameters.k === 99) return new Promise(() => {});
        if (asked.command.kind === 'next_step') this.step += 1;
        return this.reply();
      },
    });
  }

  /** Posts from inside a request, as the real worker does. */
  tell(fraction: number): void {
    this.inside.postMessage({ progress: { stage: 'factorising', fraction, vertices: 1 } } satisfies ProgressMessage);
  }

  private reply(): Outcome<Reply> {
    const { step } = this;
    return { ok: true, value: { frame: {}, checkpoint: { step } } as unknown as Reply };
  }
}

const workers: FakeWorker[] = [];
/** What onProgress was called with. */
const told: number[] = [];
/** Lets the messages that have been posted arrive. */
const turn = () => new Promise((done) => setImmediate(done));
const newClient = () =>
  new SolverClient({
    createWorker: () => {
      const worker = new FakeWorker();
      workers.push(worker);
      return worker as unknown as Worker;
    },
    wasmBinary: async () => {
      if (!online) throw new Error('HTTP 404');
      return new ArrayBuffer(0);
    },
    onProgress: (progress) => told.push(progress.fraction),
  });

afterEach(() => {
  for (const worker of workers.splice(0)) worker.terminate();
  told.length = 0;
  vi.useRealTimers();
});

describe('the solver’s client', () => {
  it('replaces a worker that trapped and puts it back at the last good checkpoint, with the last good request', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    await client.run(request(5, 'next_step'));
    await client.run(request(6, 'next_step'));
    await expect(client.run(request(13))).rejects.toThrow(SolverCrash);
    expect(workers).toHaveLength(2);
    expect(workers[1].opened).toMatchObject([
      { from: { step: 3 }, request: { parameters: { k: 6 }, command: { kind: 'stay' } } },
    ]);
    expect(await client.run(request(6, 'next_step'))).toMatchObject({ ok: true, value: { checkpoint: { step: 4 } } });
  });

  it('notices a worker that dies without an answer', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    const asked = client.run(request(2));
    for (let turn = 0; turn < 3; turn++) await null; // it has been sent, but a message takes longer
    workers[0].dispatchEvent(new Event('error'));
    await expect(asked).rejects.toThrow(SolverCrash);
    expect(workers).toHaveLength(2);
  });

  it('survives a restoration that fails too, and tries again with the next call', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    await client.run(request(2, 'next_step'));
    dying = true;
    await expect(client.run(request(13))).rejects.toThrow(SolverCrash);
    dying = false;
    expect(await client.run(request(2, 'next_step'))).toMatchObject({ ok: true, value: { checkpoint: { step: 3 } } });
  });

  it('goes on with the problem before when another is refused halfway', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    await client.run(request(2, 'next_step'));
    expect(await client.open(problem, request(0))).toMatchObject({ ok: false });
    expect(await client.run(request(2, 'next_step'))).toMatchObject({ ok: true, value: { checkpoint: { step: 3 } } });
  });

  it('leaves no worker behind that could not be started, and starts another when asked again', async () => {
    const client = newClient();
    online = false;
    await expect(client.start()).rejects.toThrow('HTTP 404');
    online = true;
    expect(workers.map(({ ended }) => ended)).toEqual([true]);
    expect(await client.open(problem, request(1))).toMatchObject({ ok: true });
  });

  it('passes on what went wrong', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    await expect(client.run(request(13))).rejects.toThrow('unreachable');
  });

  it('passes on how far a request is', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    const asked = client.run(request(99));
    await turn();
    workers[0].tell(0.25);
    workers[0].tell(0.5);
    await turn();
    expect(told).toEqual([0.25, 0.5]);
    client.cancel();
    await expect(asked).rejects.toThrow(SolverCancelled);
  });

  it('gives a request up when told to: nothing more is heard of it, and the last good state is back', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    await client.run(request(5, 'next_step'));
    const asked = client.run(request(99));
    await turn();
    workers[0].tell(0.5);
    client.cancel();
    await expect(asked).rejects.toThrow(SolverCancelled);
    expect(told).toEqual([]);
    expect(workers[1].opened).toMatchObject([{ from: { step: 2 }, request: { parameters: { k: 5 } } }]);
    expect(await client.run(request(5, 'next_step'))).toMatchObject({ ok: true, value: { checkpoint: { step: 3 } } });
  });

  it('leaves no worker behind when it is ended, between requests or in one', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    client.end();
    expect(workers.map(({ ended }) => ended)).toEqual([true]);
    await expect(client.run(request(1))).rejects.toThrow(SolverCancelled);

    const other = newClient();
    await other.open(problem, request(1));
    const asked = other.run(request(99));
    await turn();
    other.end();
    await expect(asked).rejects.toThrow(SolverCancelled);
    expect(workers.map(({ ended }) => ended)).toEqual([true, true]);

    const third = newClient();
    const opening = third.open(problem, request(1));
    third.end(); // while the solver's file is still on its way
    await expect(opening).rejects.toThrow(SolverCancelled);
    expect(workers.map(({ ended }) => ended)).toEqual([true, true, true]);
  });

  it('has nothing to give up between requests', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    client.cancel();
    await client.run(request(1));
    expect(workers).toHaveLength(1);
  });

  it('waits as long as there are signs of life, and no longer', async () => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
    const client = newClient();
    await client.open(problem, request(1));
    const asked = client.run(request(99));
    await turn();
    for (const fraction of [0.1, 0.2, 0.3]) {
      vi.advanceTimersByTime(50_000);
      workers[0].tell(fraction);
      await turn();
    }
    expect(workers).toHaveLength(1);
    vi.advanceTimersByTime(60_000);
    await expect(asked).rejects.toThrow('no sign of life');
    expect(workers).toHaveLength(2);
  });
});
