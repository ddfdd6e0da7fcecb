import wasmUrl from '#wasm/solver.wasm?url';
import { SolverClient } from '../solver/client.ts';
import { Obstacle } from './obstacle.ts';

/** Fetches the solver and makes ready the worker that will run it. Throws Obstacle when this browser or this network cannot. */
export async function startSolver(): Promise<SolverClient> {
  if (typeof WebAssembly !== 'object') throw new Obstacle('page.errors.noWebAssembly');
  if (!document.createElement('canvas').getContext('webgl2')) throw new Obstacle('page.errors.noWebGL');
  const client = new SolverClient({
    createWorker: () => new Worker(new URL('../solver/worker.ts', import.meta.url), { type: 'module' }),
    wasmBinary: await fetchSolver(),
  });
  try {
    await client.start();
  } catch (reason) {
    throw new Obstacle('page.errors.solverStart', { reason: (reason as Error).message });
  }
  return client;
}

async function fetchSolver(): Promise<ArrayBuffer> {
  try {
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error(`HTTP ${response.status}`);
    return await response.arrayBuffer();
  } catch (reason) {
    throw new Obstacle('page.errors.wasmMissing', { url: wasmUrl, reason: (reason as Error).message });
  }
}
