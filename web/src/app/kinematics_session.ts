import { batch, computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import type { IkAnswer, IkTask } from '../solver/inverse_kinematics.ts';
import type { KinematicsService } from '../solver/kinematics_worker.ts';
import type { Outcome } from '../solver/protocol.ts';
import { Crew } from './crew.ts';
import { notifyRefusal } from './explanation.ts';
import { defaultKinematics, type KinematicsSettings, taskOf } from './kinematics.ts';
import { state } from './state.ts';

/** What the arm was asked for, and what came of it. */
export interface Search {
  task: IkTask;
  answer: IkAnswer;
}

export interface Pose {
  /** #joints×3, m. */
  x: Float64Array;
  /** #joints×4, (x, y, z, w): of each joint against the one before. */
  q: Float64Array;
}

/** Makes the arm do what the state says, one wish after the other; what is refused is taken back in the state. */
export class KinematicsSession {
  /** The latest search, whose events can be gone through; null before the first. */
  readonly search = signal<Search | null>(null);
  /** How many of its events have happened in what is shown. */
  readonly event = signal(0);
  /** What is shown; null before the first search. */
  readonly pose: ReadonlySignal<Pose | null> = computed(() => {
    const { value: search } = this.search;
    return search && poseAfter(search.answer, this.event.value);
  });

  private readonly crew: Crew<KinematicsService>;
  /** What the arm does; null before it does anything. */
  private accepted: KinematicsSettings | null = null;
  private working = false;

  constructor(createWorker: () => Worker = kinematicsWorker, wasmBinary?: () => Promise<ArrayBuffer>) {
    this.crew = new Crew(createWorker, undefined, wasmBinary);
  }

  /** Begins to follow the state. Returns how to stop, which ends the worker. */
  follow(): () => void {
    const wanted = computed(() => state.value.kinematics);
    const stop = effect(() => {
      void wanted.value;
      untracked(() => void this.pursue());
    });
    return () => {
      stop();
      this.crew.leave();
      this.accepted = null;
    };
  }

  /** Until what the arm does is what is wanted: the last wish wins. */
  async pursue(): Promise<void> {
    if (this.working) return;
    this.working = true;
    try {
      while (state.value.kinematics !== this.accepted) {
        const wanted = state.value.kinematics;
        if (await this.make(wanted)) this.accepted = wanted;
        else if (!this.fallBack(wanted)) return;
      }
    } finally {
      this.working = false;
    }
  }

  /** Looks for the target once more, from a chain that hangs down, and shows that. */
  async hang(): Promise<void> {
    const { accepted } = this;
    if (accepted && (await this.reach(taskOf(accepted)))) this.event.value = 0;
  }

  /** Shows the pose after so many events. */
  seek(event: number): void {
    const { value: search } = this.search;
    if (search) this.event.value = Math.min(Math.max(0, event), countEvents(search.answer));
  }

  private async make(wanted: KinematicsSettings): Promise<boolean> {
    const { accepted } = this;
    const { value: search } = this.search;
    const task = taskOf(wanted);
    if (!accepted || !search || !isSame(chainOf(accepted), chainOf(wanted))) return this.reach(task);
    if (isSame(taskOf(accepted), task)) return true;
    // From where the arm is; for the same target by other means from where it was, so that both can be compared.
    const start_q = isSame(accepted.target, wanted.target) ? search.answer.start_q : search.answer.q;
    return this.reach({ ...task, start_q });
  }

  /** Says why, where the target is refused. */
  private async reach(task: IkTask): Promise<boolean> {
    const outcome = await this.crew.ask<Outcome<IkAnswer>>(async (service) => service.solve(task));
    if (outcome && !outcome.ok) notifyRefusal(outcome.status);
    if (!outcome?.ok) return false;
    batch(() => {
      this.search.value = { task, answer: outcome.value };
      this.event.value = countEvents(outcome.value);
    });
    return true;
  }

  /** Puts back what was before, or at the beginning the default; what was chosen since is made next. False when there is nothing left to try. */
  private fallBack(failed: KinematicsSettings): boolean {
    if (state.value.kinematics !== failed) return true;
    const last = this.accepted ?? defaultKinematics;
    if (failed === last) return false;
    state.value = { ...state.value, kinematics: last };
    return true;
  }
}

export function countEvents(answer: IkAnswer): number {
  return answer.events.length / 3;
}

/** After so many of the answer's events; the last is where it ended. */
export function poseAfter(answer: IkAnswer, events: number): Pose {
  if (events === countEvents(answer)) return { x: answer.x, q: answer.q };
  if (events === 0) return { x: answer.start_x, q: answer.start_q };
  const joints = answer.x.length / 3;
  return {
    x: answer.event_x.subarray(3 * joints * (events - 1), 3 * joints * events),
    q: answer.event_q.subarray(4 * joints * (events - 1), 4 * joints * events),
  };
}

function chainOf({ links, root }: KinematicsSettings) {
  return { lengths: links.map(({ length }) => length), root };
}

function isSame(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}

function kinematicsWorker(): Worker {
  return new Worker(new URL('../solver/kinematics_worker.ts', import.meta.url), { type: 'module' });
}
