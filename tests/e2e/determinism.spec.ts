import { createRequire } from 'node:module';
import { loadSolver } from '../../web/headless/load_solver.ts';
import type { SolverService } from '../../web/src/solver/protocol.ts';
import { hashOf, type Run, runInNode, runs } from '../support/same_bits.ts';
import { expect, open, test } from './support/page.ts';

const comlinkPath = createRequire(import.meta.url).resolve('comlink/dist/umd/comlink.js');

test.use({ bypassCSP: true }); // comlink is a script of the test's, not of the page's

/** On the page: starts another solver from the page's own files, and plays the run there. Returns #V×3, m. */
async function play({ run, worker, wasm }: { run: Run; worker: string; wasm: string }): Promise<Float64Array> {
  const { scene, parameters, steps } = run;
  const { wrap } = (globalThis as unknown as { Comlink: typeof import('comlink') }).Comlink;
  const solver = wrap(new Worker(worker, { type: 'module' })) as unknown as SolverService;
  await solver.start(await (await fetch(wasm)).arrayBuffer());
  const targets = Float64Array.from([...scene.pinned].flatMap((v) => [...scene.V.subarray(3 * v, 3 * v + 3)]));
  const request = {
    parameters,
    pins: { pinned: scene.pinned, targets },
    command: { kind: 'play', steps },
    selectedVertex: null,
    wholeTrace: false,
    profile: false,
  } as const;
  const outcome = await solver.open(scene, request, null);
  if (!outcome.ok) throw new Error(`${outcome.status.code}: ${outcome.status.field}`);
  return outcome.value.frame.p;
}

test('the page’s worker ends in the same bits as Node', async ({ page }) => {
  const worker = page.waitForEvent('worker', (started) => /\/worker-[^/]*\.js$/.test(started.url()));
  const wasm = page.waitForResponse(/\.wasm$/);
  await open(page);
  await page.addScriptTag({ path: comlinkPath });
  const files = { worker: (await worker).url(), wasm: (await wasm).url() };
  const solver = await loadSolver();
  for (const run of runs) {
    const positions = await page.evaluate(play, { run, ...files });
    expect(hashOf(positions), run.name).toBe(hashOf(runInNode(solver, run)));
  }
});
