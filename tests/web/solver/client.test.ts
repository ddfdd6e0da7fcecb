import { expose } from 'comlink';
import { afterEach, describe, expect, it } from 'vitest';
import { SolverClient, SolverCrash } from '../../../web/src/solver/client.ts';
import type { Checkpoint, Outcome, Problem, Reply, Request } from '../../../web/src/solver/protocol.ts';

const problem: Problem = { V: new Float64Array(3), E: new Int32Array(0), m: Float64Array.of(1) };
const request = (k: number, kind: 'stay' | 'next_step' = 'stay') =>
  ({ parameters: { k }, command: { kind }, wholeTrace: false }) as unknown as Request;

/** Whether new workers die as soon as a problem is opened in them. */
let dying = false;

/** Each "worker" answers with the number of the step it stands at, and dies of k = 13 as a trapped module does. */
class FakeWorker extends EventTarget {
  readonly opened: { from: Checkpoint | null; request: Request }[] = [];
  private step = 0;
  private readonly port: MessagePort;

  constructor() {
    super();
    const { port1, port2 } = new MessageChannel();
    this.port = port1;
    expose(
      {
        start: async () => {},
        open: async (_: Problem, asked: Request, from: Checkpoint | null) => {
          if (dying) throw new WebAssembly.RuntimeError('out of memory');
          this.opened.push({ from, request: asked });
          this.step = from?.step ?? 1;
          return this.reply();
        },
        run: async (asked: Request) => {
          if (asked.parameters.k === 13) throw new WebAssembly.RuntimeError('unreachable');
          if (asked.command.kind === 'next_step') this.step += 1;
          return this.reply();
        },
      },
      port2,
    );
  }

  postMessage(message: unknown, transfer: Transferable[]): void {
    this.port.postMessage(message, transfer);
  }

  override addEventListener(type: string, listener: EventListener): void {
    if (type === 'message') this.port.addEventListener(type, listener);
    else super.addEventListener(type, listener);
  }

  start(): void {
    this.port.start();
  }

  terminate(): void {
    this.port.close();
  }

  private reply(): Outcome<Reply> {
    const { step } = this;
    return { ok: true, value: { frame: {}, checkpoint: { step } } as unknown as Reply };
  }
}

const workers: FakeWorker[] = [];
const newClient = () =>
  new SolverClient({
    createWorker: () => {
      const worker = new FakeWorker();
      workers.push(worker);
      return worker as unknown as Worker;
    },
    wasmBinary: async () => new ArrayBuffer(0),
  });

afterEach(() => {
  for (const worker of workers.splice(0)) worker.terminate();
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

  it('passes on what went wrong', async () => {
    const client = newClient();
    await client.open(problem, request(1));
    await expect(client.run(request(13))).rejects.toThrow('unreachable');
  });
});
