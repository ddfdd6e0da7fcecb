import { formatNumber, formatQuantity, formatVector } from '../lib/format.ts';
import { row, subtract, type Vector } from '../lib/vector.ts';
import { type SymbolId, symbol } from '../notation/symbols.ts';
import type { Scene } from '../scene/scene.ts';
import type { Frame, TraceEvent } from '../solver/frame.ts';
import type { Parameters } from '../solver/module.ts';
import { countAlong, type Figure } from './figure.ts';
import type { Selection } from './state.ts';

/** How large a symbol's array is in a figure, e.g. "220 × 3"; empty for a single number. */
export function sizeOf(id: SymbolId, figure: Figure): string {
  return symbol(id)
    .shape.map((axis) => countAlong(axis, figure))
    .join(' × ');
}

/** What a symbol is at present in a figure; of an array the row of the spring or vertex. Null where the page does not know. */
export function symbolValue(id: SymbolId, figure: Figure, { spring, vertex }: Selection): string | null {
  const frame = figure.frame.value;
  if (!frame) return null;
  const now: Now = {
    scene: figure.scene.value,
    r: figure.r.value,
    parameters: figure.parameters.value,
    frame,
    event: frame.events[frame.half_step],
  };
  const numbers =
    numberOf[id]?.(now) ??
    (spring === null ? null : rowOfSpring[id]?.(now, spring)) ??
    (vertex === null ? null : rowOfVertex[id]?.(now, vertex));
  return numbers ? written(numbers, symbol(id).unit) : null;
}

interface Now {
  scene: Scene;
  /** #E, m. */
  r: Float64Array;
  parameters: Parameters;
  frame: Frame;
  /** Of the half-step; nobody knows it while the clock runs. */
  event: TraceEvent | undefined;
}

const energy = (name: 'objective' | 'surrogate' | 'potential' | 'inertia' | 'external' | 'pin') => (now: Now) =>
  now.event && [now.event[name]];

const numberOf: Partial<Record<SymbolId, (now: Now) => Vector | undefined>> = {
  vertexCount: ({ scene }) => [scene.m.length],
  springCount: ({ scene }) => [scene.E.length / 2],
  k: ({ parameters }) => [parameters.k],
  deltaT: ({ parameters }) => [parameters.delta_t],
  w: ({ parameters }) => [parameters.w],
  g: ({ parameters }) => [0, -parameters.gravity, 0],
  kappa: ({ frame }) => [frame.stiffnessNumber],
  objective: energy('objective'),
  surrogate: energy('surrogate'),
  potential: energy('potential'),
  inertia: energy('inertia'),
  external: energy('external'),
  pinEnergy: energy('pin'),
};

const rowOfSpring: Partial<Record<SymbolId, (now: Now, e: number) => Vector | null>> = {
  E: ({ scene }, e) => [scene.E[2 * e], scene.E[2 * e + 1]],
  r: ({ r }, e) => [r[e]],
  v: ({ scene: { E }, frame: { p } }, e) => subtract(row(p, E[2 * e]), row(p, E[2 * e + 1])),
  d: ({ frame: { d } }, e) => d && row(d, e),
};

const rowOfVertex: Partial<Record<SymbolId, (now: Now, i: number) => Vector | null>> = {
  V: ({ scene }, i) => row(scene.V, i),
  m: ({ scene, parameters }, i) => [parameters.mass_scale * scene.m[i]],
  p: ({ frame }, i) => row(frame.p, i),
  pCurr: ({ frame }, i) => row(frame.pCurr, i),
  pPrev: ({ frame }, i) => row(frame.pPrev, i),
  velocity: ({ frame: { pCurr, pPrev }, parameters }, i) =>
    subtract(row(pCurr, i), row(pPrev, i)).map((moved) => moved / parameters.delta_t),
  fExt: externalForce,
  pTarget: ({ frame: { pinned, targets } }, i) => (pinned.includes(i) ? row(targets, pinned.indexOf(i)) : null),
  y: ({ frame: { vertexEquation } }, i) => (vertexEquation?.vertex === i ? vertexEquation.y : null),
  b: ({ frame: { vertexEquation, phase } }, i) =>
    vertexEquation?.vertex === i && phase !== 'predict' ? vertexEquation.b : null, // without d there is no b
};

/** What is left of the prediction, 2p^t − p^{t−Δt} + Δt² f^ext/m, without its inertia. */
function externalForce({ scene, parameters, frame: { prediction, pCurr, pPrev } }: Now, i: number): Vector {
  const mass = parameters.mass_scale * scene.m[i];
  return row(pCurr, i).map((now, axis) => {
    const before = pPrev[3 * i + axis];
    const pushed = prediction[3 * i + axis] - (2 * now - before);
    const rounding = 2 * Number.EPSILON * (2 * Math.abs(now) + Math.abs(before));
    return Math.abs(pushed) <= rounding ? 0 : (mass * pushed) / parameters.delta_t ** 2;
  });
}

/** Numbers in a unit, whole ones without decimals where there is none. */
export function written(numbers: Vector, unit: string | null): string {
  if (unit !== null) return numbers.length === 1 ? formatQuantity(numbers[0], unit) : formatVector(numbers, unit);
  const plain = numbers.map((number) => (Number.isInteger(number) ? String(number) : formatNumber(number)));
  return numbers.length === 1 ? plain[0] : `(${plain.join(', ')})`;
}
