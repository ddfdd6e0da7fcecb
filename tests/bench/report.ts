import type { HalfSteps } from './half_steps.ts';
import type { IntegratorTimes } from './integrators.ts';
import type { Bandwidth } from './native_reference.ts';
import type { Comparison, SceneTimes } from './paired_rounds.ts';
import type { SameAccuracy } from './same_accuracy.ts';
import type { SizeSweep } from './size_sweep.ts';

/** What results.json holds. Times in ms. */
export interface Report {
  machine: { cpu: string; node: string; bandwidth: Bandwidth[] };
  /** Bytes. */
  wasm: { raw: number; gzip: number };
  scenes: (SceneTimes & { scene: string; halfSteps: HalfSteps; sameAccuracy: SameAccuracy })[];
  sizes: SizeSweep;
  integrators: IntegratorTimes[];
}

/** Three digits of every measured number. */
export function rounded(report: Report): Report {
  return JSON.parse(JSON.stringify(report), (_, value) =>
    typeof value === 'number' && !Number.isInteger(value) ? Number(value.toPrecision(3)) : value,
  );
}

export function printTables({ machine, wasm, scenes, sizes, integrators }: Report): void {
  console.log(`${machine.cpu}, Node ${machine.node}; the module has ${wasm.raw} bytes, ${wasm.gzip} zipped.`);
  const table = (title: string, rows: object[]) => {
    console.log(`\n${title}`);
    console.table(rows);
  };
  const times = ({ vertices, springs, nonzeros }: SceneTimes, comparison: Comparison) => ({
    vertices,
    springs,
    'nnz(L)': nonzeros,
    ...comparison,
  });
  const named = (figures: (scene: SceneTimes) => Comparison) =>
    scenes.map((entry) => ({ scene: entry.scene, ...times(entry, figures(entry)) }));

  table(
    'ms an iteration',
    named(({ iteration }) => iteration),
  );
  table(
    'ms of its halves on the fast path',
    scenes.map(({ scene, halfSteps }) => ({ scene, ...halfSteps })),
  );
  table(
    'ms to set a scene: matrices and factorisation',
    named(({ precompute }) => precompute),
  );
  table(
    'ms to change k: factorisation alone',
    named(({ refactorise }) => refactorise),
  );
  table(
    'ms to the objective of 50 native iterations, at five instants together',
    scenes.flatMap(({ scene, sameAccuracy }) => sameAccuracy.methods.map((method) => ({ scene, ...method }))),
  );
  table(
    'm between native positions and those of the fast path after 80 time steps, at most',
    scenes.map(({ scene, sameAccuracy }) => ({ scene, difference: sameAccuracy.difference })),
  );
  table(
    'cloth of growing size: ms an iteration',
    sizes.sheets.map((sheet) => times(sheet, sheet.iteration)),
  );
  table(
    'cloth of growing size: ms to set the scene',
    sizes.sheets.map((sheet) => times(sheet, sheet.precompute)),
  );
  table('grows as the number of vertices to the power of', [sizes.exponents]);
  table(
    'ms a time step by every method, and time steps of linearly implicit Euler a second',
    integrators.map(({ scene, steps, perSecond }) => ({ scene, ...steps, 'a second': perSecond })),
  );
  table('reading memory natively: GB/s by the size of the array in MB', machine.bandwidth);
}
