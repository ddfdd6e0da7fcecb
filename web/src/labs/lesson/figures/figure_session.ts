import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { Clock } from '../../../app/clock.ts';
import { type Explanation, explanationOf, explanationOfRefusal } from '../../../app/explanation.ts';
import type { Figure } from '../../../app/figure.ts';
import { findScene } from '../../../app/scene_library.ts';
import { type Adjustable, type AppState, type Pin, parametersOn, pinsOn, type Selection } from '../../../app/state.ts';
import { noScene, type Scene } from '../../../scene/scene.ts';
import type { Frame } from '../../../solver/frame.ts';
import type { Checkpoint, Command, Inspection, Opened, Outcome, Request } from '../../../solver/protocol.ts';
import { FigureTimeline, type Move } from './figure_timeline.ts';
import type { LessonSolver, Moment } from './lesson_solver.ts';
import type { PlanarScene } from './planar_scenes.ts';

export interface FigureSettings {
  scene: PlanarScene;
  /** What differs from the scene's own. */
  parameters?: Partial<Adjustable>;
  pins?: readonly Pin[];
  selection?: Selection;
  /** What has happened when the reader comes; to this the figure resets. */
  opening?: readonly Command[];
}

/** What the reader can ask for and the solver refuse. */
interface Choice {
  chosen: Partial<Adjustable>;
  pins: readonly Pin[] | null;
}

/** Moves that may wait for the solver; more are a held key. */
const longestQueue = 4;

/** Drives one figure as app/session.ts drives the lab, but keeps the moment itself: between two requests the solver serves other figures. */
export class FigureSession implements Figure {
  readonly scene = signal<Scene>(noScene);
  /** #E, m: rest lengths. */
  readonly r = signal<Float64Array>(new Float64Array(0));
  readonly frame = signal<Frame | null>(null);
  readonly playing = signal(false);
  /** The parameters that differ from the scene's own. */
  readonly chosen = signal<Partial<Adjustable>>({});
  readonly parameters = computed(() => parametersOn(this.scene.value, this.chosen.value));
  readonly pins = signal<readonly Pin[] | null>(null);
  readonly selection = signal<Selection>({ spring: null, vertex: null });
  /** The vertex that the reader holds, pinned or not, and where: time runs as long as it is held. */
  readonly held = signal<Pin | null>(null);
  /** Why the last request was refused. */
  readonly refusal = signal<Explanation | null>(null);
  /** Whether the figure is on the screen: elsewhere it sleeps. */
  readonly awake = signal(false);

  /** Whether the clock runs. */
  private readonly running = computed(() => this.awake.value && (this.playing.value || this.held.value !== null));

  readonly settings: FigureSettings;
  private readonly solver: LessonSolver;
  private readonly clock = new Clock();
  private readonly queue: Move[] = [];
  private readonly timeline = new FigureTimeline();
  private beginning: Checkpoint | null = null;
  /** What the solver took last, and what it was last asked for. */
  private accepted: Choice;
  private tried: Choice;
  private busy = false;
  private stale = false;

  constructor(solver: LessonSolver, settings: FigureSettings) {
    this.solver = solver;
    this.settings = settings;
    this.setBack();
    this.accepted = this.tried = this.choice();
  }

  /** Begins to follow its signals and the display's refresh. Returns how to stop. */
  start(): () => void {
    const stopFollowing = effect(() => {
      void [this.chosen.value, this.pins.value, this.held.value, this.selection.value]; // they change the picture
      if (!this.awake.value) return;
      untracked(() => {
        this.stale = true;
        void this.pump();
      });
    });
    let asked = 0;
    const tick = (now: number) => {
      asked = requestAnimationFrame(tick);
      if (this.busy) return;
      const steps = this.clock.due(now, this.parameters.value.delta_t);
      if (steps > 0) this.order({ kind: 'play', steps });
    };
    const stopClock = effect(() => {
      cancelAnimationFrame(asked);
      this.clock.rest();
      if (this.running.value) asked = requestAnimationFrame(tick);
    });
    return () => {
      stopFollowing();
      stopClock();
      cancelAnimationFrame(asked);
    };
  }

  /** Moves the cursor, and stops the clock unless it is the clock that asks. */
  order(move: Move): void {
    if (move.kind !== 'play') this.playing.value = false;
    if (move.kind === 'reset') this.queue.length = 0; // from wherever those would have led
    if (this.queue.length < longestQueue) this.queue.push(move);
    void this.pump();
  }

  /** As when the reader came. */
  reset(): void {
    this.setBack();
    if (this.beginning) this.order({ kind: 'jump', to: this.beginning });
  }

  setParameter<Name extends keyof Adjustable>(name: Name, value: Adjustable[Name]): void {
    this.chosen.value = { ...this.chosen.value, [name]: value };
  }

  selectSpring(spring: number): void {
    this.selection.value = { ...this.selection.value, spring };
  }

  selectVertex(vertex: number): void {
    this.selection.value = { ...this.selection.value, vertex };
  }

  movePin(vertex: number, target: Pin['target']): void {
    this.pins.value = this.pinsOf(this.scene.value).map((pin) => (pin.vertex === vertex ? { vertex, target } : pin));
  }

  /** A pin stays where it is let go, any other vertex is free again. */
  letGo(): void {
    const { value: held } = this.held;
    batch(() => {
      if (held) this.movePin(held.vertex, held.target);
      this.held.value = null;
    });
  }

  /** The matrices at the present moment, and E at points of the caller's choice, each #V×3, m. Null where there is no moment yet. */
  async inspect(points: readonly Float64Array[] = []): Promise<Inspection | null> {
    const { here } = this.timeline;
    if (!here) return null;
    try {
      return await this.solver.inspect(this.moment(this.scene.value, here, { kind: 'stay' }), points);
    } catch (reason) {
      this.refuse(explanationOf(reason));
      return null;
    }
  }

  /** What the lab needs to show the same. Null where there is nothing to show yet. */
  forLab(): { state: Pick<AppState, 'scene' | 'parameters' | 'pins' | 'selection'>; from: Checkpoint } | null {
    const { here } = this.timeline;
    if (!here) return null;
    const { chosen, pins, selection } = this;
    const state = {
      scene: this.settings.scene,
      parameters: chosen.value,
      pins: pins.value && [...pins.value],
      selection: selection.value,
    };
    return { state, from: here };
  }

  /** The moment shown; null before the first. */
  checkpoint(): Checkpoint | null {
    return this.timeline.here;
  }

  /** Whether a move is on its way: another moment will be shown. */
  get moving(): boolean {
    return this.busy;
  }

  /** The moments that can be gone back to, the oldest first. */
  earlier(): readonly Checkpoint[] {
    return this.timeline.past;
  }

  private setBack(): void {
    this.queue.length = 0;
    batch(() => {
      this.playing.value = false;
      this.chosen.value = this.settings.parameters ?? {};
      this.pins.value = this.settings.pins ?? null;
      this.selection.value = this.settings.selection ?? { spring: 0, vertex: null };
      this.held.value = null;
      this.refusal.value = null;
    });
  }

  private async pump(): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    try {
      if (!this.frame.value) await this.open();
      for (let move = this.next(); move && this.frame.value; move = this.next())
        await this.make(move, this.frame.value);
    } catch (reason) {
      this.refuse(explanationOf(reason));
      this.fallBack();
    } finally {
      this.busy = false;
    }
  }

  private next(): Move | null {
    return this.queue.shift() ?? (this.stale && !this.running.value ? { kind: 'stay' } : null);
  }

  private async open(): Promise<void> {
    const scene = await findScene(this.settings.scene);
    this.startRequest();
    let outcome = await this.solver.run(this.moment(scene, null, { kind: 'stay' }));
    for (const command of this.settings.opening ?? []) {
      if (outcome.ok) outcome = await this.solver.run(this.moment(scene, outcome.value.checkpoint, command));
    }
    this.take(scene, outcome);
    this.beginning = this.timeline.here;
  }

  private async make(move: Move, { last_half_step }: Frame): Promise<void> {
    const scene = this.scene.value;
    const { from, command } = this.timeline.begin(move);
    this.startRequest();
    const outcome = await this.solver.run(this.moment(scene, from, command));
    if (outcome.ok && command.kind === 'play') this.clock.spent(command.steps, outcome.value.frame.milliseconds);
    this.take(scene, outcome, last_half_step);
  }

  /** What is chosen from now on is asked for next. */
  private startRequest(): void {
    this.stale = false;
    this.tried = this.choice();
  }

  private moment(scene: Scene, from: Checkpoint | null, command: Command): Moment {
    const request: Request = {
      parameters: parametersOn(scene, this.chosen.value),
      pins: pinsOn(scene, this.pinsInForce(scene)),
      command,
      selectedVertex: this.selection.value.vertex,
      wholeTrace: command.kind !== 'play',
      profile: false,
    };
    return { problem: scene, request, from };
  }

  /** Shows what came of a request. `last_half_step` is that of the time step it started from. */
  private take(scene: Scene, outcome: Outcome<Opened>, last_half_step = 0): void {
    if (!outcome.ok) {
      const { status } = outcome;
      this.refuse(explanationOfRefusal(status));
      this.fallBack();
      return;
    }
    this.accepted = this.tried;
    const { frame, checkpoint, r } = outcome.value;
    this.timeline.reach(checkpoint, last_half_step);
    batch(() => {
      this.refusal.value = null;
      this.scene.value = scene;
      this.r.value = r;
      this.frame.value = { ...frame, rememberedSteps: this.timeline.past.length };
    });
  }

  private refuse(why: Explanation): void {
    this.playing.value = false;
    this.queue.length = 0;
    this.refusal.value = why;
  }

  /** Puts the last accepted parameters and pins back, unless the reader has moved on: what was chosen since is asked for next. */
  private fallBack(): void {
    const { chosen, pins } = this.choice();
    if (chosen !== this.tried.chosen || pins !== this.tried.pins) return;
    const { stale } = this;
    batch(() => {
      this.chosen.value = this.accepted.chosen;
      this.pins.value = this.accepted.pins;
    });
    this.stale = stale; // the picture is that of the accepted ones already
  }

  private choice(): Choice {
    return { chosen: this.chosen.value, pins: this.pins.value };
  }

  private pinsInForce(scene: Scene): Pin[] {
    const { value: held } = this.held;
    const pins = this.pinsOf(scene).filter(({ vertex }) => vertex !== held?.vertex);
    return held ? [...pins, held] : pins;
  }

  private pinsOf(scene: Scene): readonly Pin[] {
    return this.pins.value ?? Array.from(scene.pinned, (vertex) => ({ vertex, target: null }));
  }
}
