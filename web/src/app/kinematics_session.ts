import { batch, computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import { curveFrom } from '../curves/curve_from.ts';
import { sampleCurve } from '../curves/sample_curve.ts';
import { sameJson } from '../lib/same_json.ts';
import { type Followed, toFirst } from '../solver/follow_targets.ts';
import type { IkAnswer, IkTask } from '../solver/inverse_kinematics.ts';
import type { KinematicsService } from '../solver/kinematics_service.ts';
import type { Outcome } from '../solver/protocol.ts';
import { Crew } from './crew.ts';
import { isTaken } from './explanation.ts';
import { defaultKinematics, type KinematicsSettings, taskOf } from './kinematics.ts';
import { type Drawing, drawingTargets } from './kinematics_drawing.ts';
import { notify } from './notices.ts';
import { countEvents, type Pose, poseAfter, poseAt } from './pose.ts';
import { state } from './state.ts';

/** What the arm was asked for, and what came of it. */
export interface Search {
  task: IkTask;
  answer: IkAnswer;
}

interface Options {
  /** Whether a new curve is there at once; otherwise the arm begins to draw it. */
  still: boolean;
  createWorker?: () => Worker;
  wasmBinary?: () => Promise<ArrayBuffer>;
}

/** Makes the arm do what the state says, one wish after the other; what is refused is taken back in the state. */
export class KinematicsSession {
  /** The latest search, whose events can be gone through; null before the first. */
  readonly search = signal<Search | null>(null);
  /** How many of its events have happened in what is shown. */
  readonly event = signal(0);
  /** What the arm draws, and how it does; null while it only reaches for its target. */
  readonly drawing = signal<Drawing | null>(null);
  /** The target of the drawing that the arm is at. */
  readonly place = signal(0);
  readonly playing = signal(false);
  /** What is shown; null before the first search. */
  readonly pose: ReadonlySignal<Pose | null> = computed(() => {
    const drawing = this.playing.value ? this.drawing.value : null;
    if (drawing) return poseAt(drawing.followed, this.place.value);
    const { value: search } = this.search;
    return search && poseAfter(search.answer, this.event.value);
  });

  private readonly still: boolean;
  private readonly crew: Crew<KinematicsService>;
  /** What the arm does; null before it does anything. */
  private accepted: KinematicsSettings | null = null;
  private working = false;
  private left = false;

  constructor({ still, createWorker = kinematicsWorker, wasmBinary }: Options) {
    this.still = still;
    this.crew = new Crew(createWorker, undefined, wasmBinary);
  }

  /** Begins to follow the state and the display's refresh. Returns how to stop, which ends the worker. */
  follow(): () => void {
    this.left = false;
    const wanted = computed(() => state.value.kinematics);
    const stopFollowing = effect(() => {
      void wanted.value;
      untracked(() => void this.pursue());
    });
    const stopDrawing = this.drawWhilePlaying();
    return () => {
      stopFollowing();
      stopDrawing();
      this.left = true;
      this.playing.value = false;
      this.crew.leave();
      this.accepted = null;
    };
  }

  /** Until what the arm does is what is wanted: the last wish wins. */
  async pursue(): Promise<void> {
    if (this.working) return;
    this.working = true;
    try {
      while (!this.left && state.value.kinematics !== this.accepted) {
        const wanted = state.value.kinematics;
        const made = await this.make(wanted);
        if (this.left) return;
        if (made) this.accepted = wanted;
        else if (!this.fallBack(wanted)) return;
      }
    } finally {
      this.working = false;
    }
  }

  /** Looks for the target once more, from a chain that hangs down, and shows that. */
  async hang(): Promise<void> {
    const { value: search } = this.search;
    if (!search) return;
    this.playing.value = false;
    const task = { ...search.task, start: new Float64Array(), start_q: new Float64Array() };
    if (await this.reach(task)) this.event.value = 0;
  }

  /** Draws on, or from the beginning where all is drawn. */
  play(): void {
    const { value: drawing } = this.drawing;
    if (!drawing) return;
    if (this.place.value === drawing.strokes.length - 1) this.place.value = 0;
    this.playing.value = true;
  }

  /** Stops at the present target, whose search can then be gone through. */
  async pause(): Promise<void> {
    this.playing.value = false;
    await this.lookInside();
  }

  /** Shows how the arm got to this target from the one before. */
  async goTo(place: number): Promise<void> {
    const { value: drawing } = this.drawing;
    if (!drawing) return;
    this.place.value = Math.min(Math.max(0, place), drawing.strokes.length - 1);
    await this.pause();
  }

  /** Shows the pose after so many events. */
  seek(event: number): void {
    const { value: search } = this.search;
    if (search) this.event.value = Math.min(Math.max(0, event), countEvents(search.answer));
  }

  /** The same search that led to the present target, with its events. */
  private async lookInside(): Promise<void> {
    const { value: drawing } = this.drawing;
    const { accepted } = this;
    if (!drawing || !accepted) return;
    const { value: place } = this.place;
    const task = { ...taskOf(accepted), target: drawing.targets.slice(3 * place, 3 * place + 3) };
    await this.reach(place === 0 ? toFirst(task) : { ...task, start_q: poseAt(drawing.followed, place - 1).q });
  }

  private drawWhilePlaying(): () => void {
    let asked = 0;
    let begun = 0;
    let from = 0;
    let legibleSince = 0;
    const tick = (now: number) => {
      asked = requestAnimationFrame(tick);
      const last = (this.drawing.value?.strokes.length ?? 1) - 1;
      const passed = Math.max(0, now - begun); // a picture's time may lie before the moment that asked for it
      const place = Math.min(last, from + Math.floor(passed / target_ms));
      if (place !== this.place.value) {
        this.place.value = place;
        if (this.crew.queue === 0 && now > legibleSince + legible_ms) {
          legibleSince = now;
          void this.lookInside();
        }
      }
      if (place === last) void this.pause(); // also where a shorter drawing has ended it
    };
    const stop = effect(() => {
      cancelAnimationFrame(asked);
      void this.drawing.value; // another curve begins its own time
      if (!this.playing.value) return;
      begun = performance.now();
      from = this.place.peek();
      asked = requestAnimationFrame(tick);
    });
    return () => {
      stop();
      cancelAnimationFrame(asked);
    };
  }

  private make(wanted: KinematicsSettings): Promise<boolean> {
    return wanted.mode === 'draw' ? this.draw(wanted) : this.aim(wanted);
  }

  private async draw(wanted: KinematicsSettings): Promise<boolean> {
    const { accepted } = this;
    if (accepted && this.drawing.value && sameJson({ ...accepted, target: wanted.target }, wanted)) return true;
    const made = curveFrom(wanted.curve);
    if (!made.ok) {
      notify('error', 'page.errors.curve', { field: made.problem.field, column: made.problem.column });
      return false;
    }
    const drawn = drawingTargets(made.curve, sampleCurve(made.curve, wanted.sampling, wanted.points));
    const outcome = await this.crew.ask<Outcome<Followed>>(async (service) =>
      service.follow(taskOf(wanted), drawn.targets),
    );
    if (!outcome || !isTaken(outcome)) return false;
    const another = !accepted || accepted.mode === 'aim' || !sameJson(accepted.curve, wanted.curve);
    const last = drawn.strokes.length - 1;
    batch(() => {
      this.drawing.value = { ...drawn, followed: outcome.value, epsilon: wanted.epsilon };
      if (another) this.place.value = this.still ? last : 0;
      else this.place.value = Math.min(this.place.value, last);
    });
    this.accepted = wanted;
    await this.lookInside();
    if (another && !this.still && !this.left) this.play();
    return true;
  }

  private async aim(wanted: KinematicsSettings): Promise<boolean> {
    const task = taskOf(wanted);
    if (this.accepted?.mode === 'aim' && sameJson(taskOf(this.accepted), task)) return true;
    const start_q = this.startFor(wanted);
    const { value: drawing } = this.drawing;
    this.playing.value = false;
    this.drawing.value = null;
    if (await this.reach({ ...task, start_q })) return true;
    this.drawing.value = drawing;
    return false;
  }

  /** Where the arm is; for the same target by other means where it was, so that both can be compared. Another chain hangs down. */
  private startFor(wanted: KinematicsSettings): Float64Array {
    const { accepted } = this;
    const { value: search } = this.search;
    if (!accepted || !search || !sameJson(chainOf(accepted), chainOf(wanted))) return new Float64Array();
    if (accepted.mode === 'aim' && sameJson(accepted.target, wanted.target)) return search.answer.start_q;
    const { value: drawn } = this.pose;
    return this.playing.value && drawn ? drawn.q : search.answer.q;
  }

  /** Says why, where the target is refused. */
  private async reach(task: IkTask): Promise<boolean> {
    const outcome = await this.crew.ask<Outcome<IkAnswer>>(async (service) => service.solve(task));
    if (!outcome || !isTaken(outcome)) return false;
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

/** ms: how long numbers stand while the arm draws. */
const legible_ms = 200;

/** ms: how long the arm stays at a target. */
const target_ms = 1000 / 30;

function chainOf({ links, root }: KinematicsSettings) {
  return { lengths: links.map(({ length }) => length), root };
}

function kinematicsWorker(): Worker {
  return new Worker(new URL('../solver/kinematics_worker.ts', import.meta.url), { type: 'module' });
}
