// Builds and runs the independent native implementation in native/reference.cpp, and native/bandwidth.cpp beside it.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import type { Scene } from '../../web/src/scene/scene.ts';
import type { Parameters } from '../../web/src/solver/module.ts';
import type { TimedRun } from './timed_run.ts';

export interface NativeRun extends TimedRun {
  /** Of L. */
  nonzeros: number;
}

export interface Bandwidth {
  /** MB, of the array that is read. */
  size: number;
  /** GB/s. */
  speed: number;
}

const source = join(import.meta.dirname, 'native');
const build = join(import.meta.dirname, 'build');

/** Builds the programs, unless they are up to date. */
export function buildReference(): void {
  execFileSync('cmake', ['-S', source, '-B', build, '-G', 'Ninja'], { stdio: 'pipe' });
  execFileSync('cmake', ['--build', build], { stdio: 'pipe' });
}

/** Runs time steps from rest, without wind: `reference` for agreement, `reference_fast` for speed. */
export function runReference(
  program: 'reference' | 'reference_fast',
  { V, E, m, pinned }: Scene,
  { iterations, k, delta_t, w, gravity }: Parameters,
  steps: number,
): NativeRun {
  const header = [V.length / 3, E.length / 2, pinned.length, steps, iterations, k, delta_t, w, gravity];
  const input = [header, V, E, m, pinned].map((values) => values.join(' ')).join('\n');
  return JSON.parse(execFileSync(join(build, program), { input, encoding: 'utf8', maxBuffer: 2 ** 28 }));
}

/** How fast one core reads memory. */
export function measureBandwidth(): Bandwidth[] {
  return JSON.parse(execFileSync(join(build, 'bandwidth'), { encoding: 'utf8' }));
}
