import { computed, signal } from '@preact/signals';
import type { Minimiser, Status } from '../solver/module.ts';
import type { MethodRequest, MethodRun, Outcome } from '../solver/protocol.ts';
import { roundingOf } from '../solver/rounding_of.ts';
import { limits } from './limits.ts';
import { route } from './route.ts';
import { frame, parameters, pins, scene, state } from './state.ts';

/** A time step as a problem: p^t, p^{t−Δt} and everything E(p) depends on. */
export interface TimeStep {
  step: number;
}

/** The same time step, by all methods. */
export interface Comparison {
  of: TimeStep;
  /** In the order in which they were made. */
  runs: readonly MethodRun[];
  refusals: readonly { method: Minimiser; status: Status }[];
  /** J: smaller differences of E mean nothing. */
  rounding: number;
}

/** ms that Newton's method may take: asked for, and where it comes unasked, since a click then waits for its end. */
const newtonPatience_ms = { asked: 10_000, unasked: 3_000 };

/** How one method is run for it. */
export function comparisonRequest(method: Minimiser): MethodRequest {
  return {
    method,
    // As many as a time step may make; L-BFGS goes on to the minimum, which all are measured against.
    iterations: method === 'lbfgs' ? 1000 : limits.iterations.max,
    patience_ms: method === 'newton' ? newtonPatience_ms[newtonAsked.value ? 'asked' : 'unasked'] : 200,
  };
}

/** Newton's method can take seconds: it comes when chosen or asked for, and in the convergence room. L-BFGS first: without E* there is no gap to draw. */
const quickMethods: readonly Minimiser[] = ['lbfgs', 'local-global', 'chebyshev', 'anderson'];

export const comparison = signal<Comparison | null>(null);
const newtonAskedFor = signal<TimeStep | null>(null);

const step = computed(() => frame.value?.step ?? 0);

/** Of the parameters what E(p) depends on, and the path, which solves it a little differently. */
const physics = computed(() => {
  const { k, delta_t, w, mass_scale, gravity, wind, path, storage } = parameters.value;
  return JSON.stringify([k, delta_t, w, mass_scale, gravity, wind, path, storage]);
});

/** The present time step: another object whenever it becomes another problem. */
export const timeStep = computed<TimeStep>(() => {
  void [scene.value, physics.value, pins.value];
  return { step: step.value };
});

/** What of the springs lab is open; undefined elsewhere. */
const room = computed(() => (route.value.page === 'springs' ? route.value.room : undefined));

const isShown = computed(
  () => room.value === 'convergence' || (room.value === null && state.value.view.plot === 'comparison'),
);

const newtonAsked = computed(() => parameters.value.method === 'newton' || newtonAskedFor.value === timeStep.value);

/** Whether the comparison is to have Newton's method too. */
export const newtonWanted = computed(() => newtonAsked.value || room.value === 'convergence');

/** What the comparison on the page still lacks. */
export const missingMethod = computed<Minimiser | null>(() => {
  const now = timeStep.value; // read whether or not it is needed: what is not followed could change and change back unseen
  if (!isShown.value) return null;
  const done = comparison.value?.of === now ? comparison.value : null;
  const wanted: readonly Minimiser[] = newtonWanted.value ? [...quickMethods, 'newton'] : quickMethods;
  return wanted.find((method) => !isIn(done, method)) ?? null;
});

function isIn(done: Comparison | null, method: Minimiser): boolean {
  return done !== null && [...done.runs, ...done.refusals].some((one) => one.method === method);
}

export function compareNewton(): void {
  newtonAskedFor.value = timeStep.value;
}

/** Takes in how `method` fared on `of`, unless the page has gone on. */
export function compared(of: TimeStep, method: Minimiser, outcome: Outcome<MethodRun>): void {
  if (of !== timeStep.value) return;
  const before =
    comparison.value?.of === of
      ? comparison.value
      : { of, runs: [], refusals: [], rounding: roundingOf(frame.value?.events ?? []) };
  comparison.value = outcome.ok
    ? { ...before, runs: [...before.runs, outcome.value] }
    : { ...before, refusals: [...before.refusals, { method, status: outcome.status }] };
}
