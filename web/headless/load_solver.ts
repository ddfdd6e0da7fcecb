import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import type { CreateSolver, SolverModule } from '../src/solver/module.ts';

/** The same module that the page runs, in Node. Loaded only here, so that a wrong command line costs no compilation. */
export async function loadSolver(): Promise<SolverModule> {
  // A specifier found at run time keeps the generated code out of the type check.
  const { default: createSolver }: { default: CreateSolver } = await import(import.meta.resolve('#wasm/solver.js'));
  const wasmBinary = await readFile(fileURLToPath(import.meta.resolve('#wasm/solver.wasm')));
  return createSolver({ wasmBinary });
}
