import wasmUrl from '#wasm/solver.wasm?url';
import { SolverClient } from '../solver/client.ts';
import type { Progress } from '../solver/protocol.ts';
import { Obstacle } from './obstacle.ts';

/** A solver of its own for each page; nothing is fetched before it is started or asked. */
export function newSolver(onProgress: (progress: Progress) => void = () => {}): SolverClient {
  return new SolverClient({
    createWorker: () => new Worker(new URL('../solver/worker.ts', import.meta.url), { type: 'module' }),
    wasmBinary: fetchSolver,
    onProgress,
  });
}

/** Fetches the solver and makes ready the worker that will run it. Throws Obstacle when this browser or this network cannot. */
export async function startSolver(client: SolverClient): Promise<void> {
  if (typeof WebAssembly !== 'object') throw new Obstacle('page.errors.noWebAssembly');
  try {
    await client.start();
  } catch (reason) {
    if (reason instanceof Obstacle) throw reason;
    throw new Obstacle('page.errors.solverStart', { reason: (reason as Error).message });
  }
}

let fetched: Promise<ArrayBuffer> | null = null;

/** Once for all solvers, and again after a failure. */
export function fetchSolver(): Promise<ArrayBuffer> {
  fetched ??= fetchBytes(wasmUrl).catch((reason: Error) => {
    fetched = null;
    throw new Obstacle('page.errors.wasmMissing', { url: wasmUrl, reason: reason.message });
  });
  return fetched;
}

async function fetchBytes(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`HTTP ${response.status}`);
  return response.arrayBuffer();
}
