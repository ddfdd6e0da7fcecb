import { norm, row, subtract, type Vector } from '../lib/vector.ts';
import type { Figure } from './figure.ts';

/** A spring at present. */
export interface SpringFacts {
  /** Row e of E: the vertices it joins. */
  i: number;
  j: number;
  /** m: rest length, and ‖p_i − p_j‖. */
  r: number;
  length: number;
  /** (length − r)/r, dimensionless; null for a spring of rest length 0. */
  strain: number | null;
  /** #3, m: its latest projection; null at predict, where there is none. */
  d: Vector | null;
  /** k(length − r), N: with what it pulls at both ends; negative where it pushes. */
  pull: number;
}

/** Null before the first frame. */
export function springFacts({ scene, r, frame, parameters }: Figure, e: number): SpringFacts | null {
  if (!frame.value) return null;
  const { E } = scene.value;
  const { p, d } = frame.value;
  const [i, j, rest] = [E[2 * e], E[2 * e + 1], r.value[e]];
  const length = norm(subtract(row(p, i), row(p, j)));
  return {
    i,
    j,
    r: rest,
    length,
    strain: rest > 0 ? (length - rest) / rest : null,
    d: d && row(d, e),
    pull: parameters.value.k * (length - rest),
  };
}

/** A vertex at present. */
export interface VertexFacts {
  /** #3, m: p_i and p_i^t. */
  p: Vector;
  pCurr: Vector;
  /** kg. */
  mass: number;
  /** How many springs it is an end of. */
  springs: number;
  /** #3, m: where it is held; null where it is free. */
  target: Vector | null;
  /** #3, N: row i of b, and of Q p; null unless the vertex is the selected one, and at predict, without d. */
  equation: { b: Vector; Qp: Vector } | null;
}

/** Null before the first frame. */
export function vertexFacts({ scene, frame, parameters }: Figure, i: number): VertexFacts | null {
  if (!frame.value) return null;
  const { p, pCurr, pinned, targets, phase, vertexEquation } = frame.value;
  const pin = pinned.indexOf(i);
  return {
    p: row(p, i),
    pCurr: row(pCurr, i),
    mass: parameters.value.mass_scale * scene.value.m[i],
    springs: springsAt(scene.value.E, i),
    target: pin < 0 ? null : row(targets, pin),
    equation: vertexEquation?.vertex === i && phase !== 'predict' ? vertexEquation : null,
  };
}

/** How many springs end at a vertex. E: #E×2. */
export function springsAt(E: Int32Array, vertex: number): number {
  return E.reduce((count, end) => count + Number(end === vertex), 0);
}
