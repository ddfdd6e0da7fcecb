import { computed, signal } from '@preact/signals';
import type { SolverClient } from '../solver/client.ts';
import type {
  Elimination,
  EliminationStep,
  EliminationStepRequest,
  LinearlyImplicitMatrices,
  Matrices,
  StorageComparison,
} from '../solver/matrices.ts';
import { type Ordering, orderings, type Status } from '../solver/module.ts';
import type { Outcome } from '../solver/protocol.ts';
import { route } from './route.ts';
import { frame, parameters, pins, scene } from './state.ts';

/**
 * What the matrix room asks the solver for, and what it got. It reads the signals below and writes `matrixWishes`; the session answers while the
 * page is paused and idle, one thing at a time. What was answered for another system – scene, k, Δt, w, masses, set of pins, path – is null again
 * until it is answered anew. The matrices of linearly implicit Euler
 * are of the positions, too, and are asked for again wherever those have settled; meanwhile the last ones stand.
 */

/** Beyond the matrices themselves, which are asked for as soon as the room is open. */
export interface MatrixWishes {
  /** These orders of elimination, one after the other. */
  orderings: readonly Ordering[];
  /** Q after so many columns; asked for again whenever it becomes another. */
  step: EliminationStepRequest | null;
  /** What dense and sparse storage cost. */
  storage: boolean;
  /** The matrices of linearly implicit Euler. */
  linearlyImplicit: boolean;
}

/** What to ask the solver next. */
export type MatrixQuestion =
  | { kind: 'matrices' }
  | { kind: 'elimination'; ordering: Ordering }
  | { kind: 'step'; request: EliminationStepRequest }
  | { kind: 'storage' }
  | { kind: 'linearly-implicit'; at: SettledPositions };

/** By what its question was. */
export type MatrixAnswer =
  | { kind: 'matrices'; value: Matrices }
  | { kind: 'elimination'; value: Elimination }
  | { kind: 'step'; request: EliminationStepRequest; value: Outcome<EliminationStep> }
  | { kind: 'storage'; value: StorageComparison }
  | { kind: 'linearly-implicit'; at: SettledPositions; value: LinearlyImplicitMatrices };

/** Q p = b as something to be factorised: another object whenever it becomes another system. */
export type LinearSystem = object;

/** Where the last time step left the vertices: another object whenever that may be elsewhere. */
export type SettledPositions = object;

interface Answers {
  of: LinearSystem;
  matrices: Matrices | null;
  eliminations: Partial<Record<Ordering, Elimination>>;
  step: { request: EliminationStepRequest; value: Outcome<EliminationStep> } | null;
  storage: StorageComparison | null;
  linearlyImplicit: { at: SettledPositions; value: LinearlyImplicitMatrices } | null;
}

export const noWishes: MatrixWishes = { orderings: [], step: null, storage: false, linearlyImplicit: false };

/** Written by the room; heeded only while it is open. */
export const matrixWishes = signal<MatrixWishes>(noWishes);

const answers = signal<Answers | null>(null);

/** Of the parameters what Q depends on, and the path, which decides what of it is factorised. */
const coefficients = computed(() => {
  const { k, delta_t, w, mass_scale, path } = parameters.value;
  return JSON.stringify([k, delta_t, w, mass_scale, path]);
});

/** In the order of C's rows. Where pins are held is nothing to Q. */
const pinnedVertices = computed(() => pins.value.pinned.join());

export const linearSystem = computed<LinearSystem>(() => {
  void [scene.value, coefficients.value, pinnedVertices.value];
  return {};
});

/** That many are accepted: whatever else is changed, where they led to stays. */
const timeStepsMade = computed(() => {
  const now = frame.value;
  return now === null ? 0 : now.step - (now.phase === 'accept' ? 0 : 1);
});

const settledPositions = computed<SettledPositions>(() => {
  void [linearSystem.value, timeStepsMade.value];
  return {};
});

const current = computed(() => (answers.value?.of === linearSystem.value ? answers.value : null));

export const matrices = computed(() => current.value?.matrices ?? null);
/** Of each order that was wished for and is there. */
export const eliminations = computed<Partial<Record<Ordering, Elimination>>>(() => current.value?.eliminations ?? {});
/** The last one answered of this system, which may lag behind the wish: compare its `columns`. */
export const eliminationStep = computed<EliminationStep | null>(() => {
  const value = current.value?.step?.value;
  return value?.ok ? value.value : null;
});
/** Why there is none: too_large, with the flops it would take as value and the most as limit, or index_out_of_range. */
export const eliminationRefusal = computed<Status | null>(() => {
  const value = current.value?.step?.value;
  return value && !value.ok ? value.status : null;
});
export const storageComparison = computed(() => current.value?.storage ?? null);
export const linearlyImplicit = computed(() => current.value?.linearlyImplicit?.value ?? null);

/** What the open room still lacks. */
export const missingMatrices = computed<MatrixQuestion | null>(() => {
  // Read whether or not it is needed: what is not followed could change and change back unseen.
  const at = settledPositions.value;
  const to = route.value;
  if (to.page !== 'springs' || to.room !== 'matrices') return null;
  const { orderings: wanted, step, storage, linearlyImplicit } = matrixWishes.value;
  const got = current.value;
  if (!got?.matrices) return { kind: 'matrices' };
  if (step && !sameStep(step, got.step?.request)) return { kind: 'step', request: step };
  const ordering = orderings.find((one) => wanted.includes(one) && !got.eliminations[one]);
  if (ordering) return { kind: 'elimination', ordering };
  if (linearlyImplicit && got.linearlyImplicit?.at !== at) return { kind: 'linearly-implicit', at };
  return storage && !got.storage ? { kind: 'storage' } : null;
});

/** One request to the solver. */
export async function askMatrices(client: SolverClient, question: MatrixQuestion): Promise<MatrixAnswer> {
  switch (question.kind) {
    case 'matrices':
      return { kind: 'matrices', value: await client.matrices() };
    case 'elimination':
      return { kind: 'elimination', value: await client.elimination(question.ordering) };
    case 'step':
      return { ...question, value: await client.eliminationStep(question.request) };
    case 'storage':
      return { kind: 'storage', value: await client.compareStorage() };
    case 'linearly-implicit':
      return { ...question, value: await client.linearlyImplicit() };
  }
}

function sameStep(wanted: EliminationStepRequest, got: EliminationStepRequest | undefined): boolean {
  return got !== undefined && got.ordering === wanted.ordering && got.columns === wanted.columns;
}

/** Takes in what the solver said of `of`, unless the page has gone on. */
export function answered(of: LinearSystem, answer: MatrixAnswer): void {
  if (of !== linearSystem.value) return;
  const before = current.value ?? {
    of,
    matrices: null,
    eliminations: {},
    step: null,
    storage: null,
    linearlyImplicit: null,
  };
  answers.value = taken(before, answer);
}

function taken(before: Answers, answer: MatrixAnswer): Answers {
  switch (answer.kind) {
    case 'matrices':
      return { ...before, matrices: answer.value };
    case 'elimination':
      return { ...before, eliminations: { ...before.eliminations, [answer.value.ordering]: answer.value } };
    case 'step':
      return { ...before, step: { request: answer.request, value: answer.value } };
    case 'storage':
      return { ...before, storage: answer.value };
    case 'linearly-implicit':
      return { ...before, linearlyImplicit: { at: answer.at, value: answer.value } };
  }
}
