import type { Scene } from '../../../scene/scene.ts';

/** #V×2, N: what the springs pull at every vertex, x and y, k(‖p_j − p_i‖ − r) towards the other end of each. */
export function springPulls({ E }: Pick<Scene, 'E'>, k: number, r: Float64Array, p: Float64Array): [number, number][] {
  const pulls = Array.from({ length: p.length / 3 }, (): [number, number] => [0, 0]);
  r.forEach((rest, e) => {
    const [i, j] = [E[2 * e], E[2 * e + 1]];
    const [x, y] = [p[3 * j] - p[3 * i], p[3 * j + 1] - p[3 * i + 1]];
    const length = Math.hypot(x, y);
    const pull = length > 0 ? (k * (length - rest)) / length : 0;
    for (const [axis, difference] of [x, y].entries()) {
      pulls[i][axis] += pull * difference;
      pulls[j][axis] -= pull * difference;
    }
  });
  return pulls;
}
