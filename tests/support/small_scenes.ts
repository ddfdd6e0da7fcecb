import fc from 'fast-check';
import type { MinimisingParameters } from '../../web/src/solver/module.ts';

/** What set_scene takes: V #V×3 in metres, E #E×2, m #V in kg, pinned #pinned. */
export interface SmallScene {
  V: Float64Array;
  E: Int32Array;
  m: Float64Array;
  pinned: Int32Array;
}

/** κ is about 4 for a chain of 1 kg: rounding costs the solver less than a digit. */
export const usualParameters: MinimisingParameters = {
  k: 1e3,
  delta_t: 1 / 30,
  w: 1e10,
  mass_scale: 1,
  iterations: 10,
  method: 'local-global',
  stop_gradient: 0,
  stop_decrease: 0,
  gravity: 9.8,
  damping: 0,
  wind: false,
  path: 'plain', // the reference; fast_path.test.ts holds the other to it
  storage: 'sparse',
};

/** n vertices of 1 kg along +x from the origin, the first one pinned. */
export function chain(n: number, spacing = 0.5): SmallScene {
  return {
    V: Float64Array.from({ length: 3 * n }, (_, c) => (c % 3 === 0 ? (c / 3) * spacing : 0)),
    E: Int32Array.from({ length: 2 * (n - 1) }, (_, c) => Math.ceil(c / 2)),
    m: new Float64Array(n).fill(1),
    pinned: Int32Array.of(0),
  };
}

/** A vertical net of n×n vertices of 1 kg, 1/8 m apart, with one diagonal in each cell; its two upper corners are pinned. */
export function net(n: number): SmallScene {
  const V: number[] = [];
  const E: number[] = [];
  for (let row = 0; row < n; row++) {
    for (let column = 0; column < n; column++) {
      const here = row * n + column;
      V.push(column / 8, (n - row) / 8, 0);
      if (column + 1 < n) E.push(here, here + 1);
      if (row + 1 < n) E.push(here, here + n);
      if (column + 1 < n && row + 1 < n) E.push(here, here + n + 1);
    }
  }
  return {
    V: Float64Array.from(V),
    E: Int32Array.from(E),
    m: new Float64Array(n * n).fill(1),
    pinned: Int32Array.of(0, n - 1),
  };
}

/** A scene in the middle of a motion. */
export interface MovingScene extends SmallScene {
  parameters: MinimisingParameters;
  /** #pinned×3, #V×3, #V×3, m. */
  targets: Float64Array;
  p_curr: Float64Array;
  p_prev: Float64Array;
}

const logarithmic = (from: number, to: number) =>
  fc.double({ min: from, max: to, noNaN: true }).map((exponent) => 10 ** exponent);

/** Any springs between 2 to 10 vertices, any pins, stiffness numbers up to 1e5; metres from −1 to 1. */
export const movingScenes: fc.Arbitrary<MovingScene> = fc.integer({ min: 2, max: 10 }).chain((n) => {
  // Whole millimetres: vertices may coincide, but a length that is not zero keeps its digits.
  const coordinate = fc.integer({ min: -1000, max: 1000 }).map((millimetres) => millimetres / 1000);
  const points = (rows: number) => fc.array(coordinate, { minLength: 3 * rows, maxLength: 3 * rows });
  const pairs = Array.from({ length: n }, (_, i) => Array.from({ length: i }, (_, j) => [i, j])).flat();
  const vertices = Array.from({ length: n }, (_, i) => i);
  return fc
    .record({
      V: points(n),
      springs: fc.subarray(pairs),
      m: fc.array(logarithmic(-1, 1), { minLength: n, maxLength: n }),
      pinned: fc.subarray(vertices),
      targets: points(n),
      p_curr: points(n),
      p_prev: points(n),
      k: logarithmic(0, 5),
      delta_t: logarithmic(-3, -1),
      w: logarithmic(4, 10),
      iterations: fc.integer({ min: 1, max: 20 }),
      wind: fc.boolean(),
    })
    .map(({ V, springs, m, pinned, targets, p_curr, p_prev, ...parameters }) => ({
      V: Float64Array.from(V),
      E: Int32Array.from(springs.flat()),
      m: Float64Array.from(m),
      pinned: Int32Array.from(pinned),
      targets: Float64Array.from(targets.slice(0, 3 * pinned.length)),
      p_curr: Float64Array.from(p_curr),
      p_prev: Float64Array.from(p_prev),
      parameters: { ...usualParameters, ...parameters },
    }));
});

/** The same, moving by millimetres, with every pin where it is held: no term of the objective starts above 1e4 J. */
export const gentleScenes: fc.Arbitrary<MovingScene> = movingScenes.map((scene) => {
  const p_curr = scene.V.map((coordinate, c) => coordinate + 1e-2 * scene.p_curr[c]);
  const p_prev = p_curr.map((coordinate, c) => coordinate + 1e-3 * scene.p_prev[c]);
  const targets = Float64Array.from(scene.targets, (_, c) => p_curr[3 * scene.pinned[Math.floor(c / 3)] + (c % 3)]);
  return { ...scene, p_curr, p_prev, targets };
});
