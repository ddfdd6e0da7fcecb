// Builds and runs the independent native implementation in native/reference.cpp.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import type { Scene } from '../../web/src/scene/scene.ts';
import type { Parameters } from '../../web/src/solver/module.ts';

export interface NativeResult {
  /** #V×3, m, row-major, after the last step. */
  positions: number[];
  milliseconds: { precompute: number; steps: number[] };
}

const source = join(import.meta.dirname, 'native');
const build = join(import.meta.dirname, 'build');

/** Builds, unless it is up to date: `reference` for agreement, `reference_fast` for speed. */
export function buildReference(): void {
  execFileSync('cmake', ['-S', source, '-B', build, '-G', 'Ninja'], { stdio: 'pipe' });
  execFileSync('cmake', ['--build', build], { stdio: 'pipe' });
}

export function runReference(
  program: 'reference' | 'reference_fast',
  scene: Scene,
  { iterations, k, delta_t, w, gravity }: Parameters,
  steps: number,
): NativeResult {
  const { V, E, m, pinned } = scene;
  const header = [V.length / 3, E.length / 2, pinned.length, steps, iterations, k, delta_t, w, gravity];
  const input = [header, V, E, m, pinned].map((values) => values.join(' ')).join('\n');
  return JSON.parse(execFileSync(join(build, program), { input, encoding: 'utf8', maxBuffer: 2 ** 28 }));
}
