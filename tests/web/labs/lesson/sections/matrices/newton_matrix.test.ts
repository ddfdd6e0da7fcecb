import { expect, it } from 'vitest';
import { newtonMatrix } from '../../../../../../web/src/labs/lesson/sections/matrices/newton_matrix.ts';

const net = {
  E: new Int32Array([0, 1, 1, 2]),
  r: new Float64Array([0.5, 1]),
  m: new Float64Array([1, 2, 3]),
  pinned: [0],
};
const parameters = { k: 100, delta_t: 0.5, w: 1e3 };

/** ∂E/∂p, as mathematics has it, from the springs, the pin at its target and masses that would stay where they are. */
function gradient(p: Float64Array, at: Float64Array): Float64Array {
  const { k, delta_t, w } = parameters;
  const g = Float64Array.from(p, (x, c) => (net.m[Math.floor(c / 3)] / delta_t ** 2 + (c < 3 ? w : 0)) * (x - at[c]));
  net.r.forEach((r, e) => {
    const [i, j] = [3 * net.E[2 * e], 3 * net.E[2 * e + 1]];
    const x = [0, 1, 2].map((axis) => p[i + axis] - p[j + axis]);
    const l = Math.hypot(...x);
    x.forEach((component, axis) => {
      g[i + axis] += k * (1 - r / l) * component;
      g[j + axis] -= k * (1 - r / l) * component;
    });
  });
  return g;
}

it('is the derivative of the gradient', () => {
  const p = new Float64Array([0, 0, 0, 0.4, -0.6, 0.1, 1.1, -0.2, 0.3]);
  const H = newtonMatrix(net, p, parameters);
  const h = 1e-5;
  for (let c = 0; c < p.length; c++) {
    const [forth, back] = [h, -h].map((by) =>
      gradient(
        p.map((x, at) => (at === c ? x + by : x)),
        p,
      ),
    );
    for (let row = 0; row < p.length; row++) {
      // k h²/r² of truncation and |g| ε/h of rounding are both below 1e-6 N/m.
      expect(H[row][c]).toBeCloseTo((forth[row] - back[row]) / (2 * h), 5);
    }
  }
});
