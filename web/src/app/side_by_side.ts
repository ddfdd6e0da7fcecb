import { batch, computed, effect, signal, untracked } from '@preact/signals';
import { noScene, type Scene } from '../scene/scene.ts';
import type { Parameters } from '../solver/module.ts';
import type { Checkpoint, Outcome, Pins, Pull } from '../solver/protocol.ts';
import type {
  ChangedSideBySide,
  Instant,
  OpenedSideBySide,
  SideBySideService,
  Variant,
  VariantState,
} from '../solver/side_by_side.ts';
import { Clock } from './clock.ts';
import { Crew } from './crew.ts';
import { isTaken } from './explanation.ts';
import { type DistanceSample, type EnergySample, SideBySideRecord } from './side_by_side_record.ts';

/** What all variants have in common. */
export interface CommonStart {
  scene: Scene;
  pins: Pins;
  /** Null: at rest. */
  from: Checkpoint | null;
}

/** Requests that may wait: more time steps are a held key, and only delay what the reader sees. */
const longestQueue = 4;

/** How long a curve stands while it grows. */
const legible_ms = 200;

/** Several variants of one simulation on one clock, in a worker of their own: pins that are moved move for all. Nothing of it reaches the lab's solver. */
export class SideBySide {
  readonly scene = signal<Scene>(noScene);
  /** #E, m: rest lengths. */
  readonly r = signal<Float64Array>(new Float64Array(0));
  /** One for each variant, in their order; null before they are open. */
  readonly states = signal<readonly VariantState[] | null>(null);
  /** Of each variant, after every time step since the start, or the latest of them. While time runs not at every picture, because nobody reads so fast. */
  readonly energies = signal<readonly (readonly EnergySample[])[]>([]);
  /** Of each variant, how far it was from the one of reference at the latest pictures. As often as energies. */
  readonly distances = signal<readonly (readonly DistanceSample[])[]>([]);
  /** Wall-clock ms of a time step of each, lately; null before the first. As often as energies. */
  readonly milliseconds = signal<readonly (number | null)[]>([]);
  /** ω, rad/s, of the fastest oscillation around where the first variant was when settings last changed. */
  readonly frequency = signal(0);
  /** Which variant the others are measured by. */
  readonly reference = signal(0);
  /** Whose motion the reader wants the same instant from. */
  readonly wantedLeader = signal(0);
  /** Time steps made since the start. */
  readonly step = signal(0);
  /** What the latest time step by all from the same motion has shown, and from whose. */
  readonly instant = signal<(Instant & { leader: number }) | null>(null);
  readonly pins = signal<Pins>({ pinned: new Int32Array(), targets: new Float64Array() });
  readonly playing = signal(false);
  /** The pin that the reader holds: time runs as long as it is held. */
  readonly held = signal<number | null>(null);
  /** What pulls at all variants: time runs as long as it does. */
  readonly pull = signal<Pull | null>(null);
  /** Which variants are still able to move. */
  readonly moving = computed<readonly number[]>(() => [...this.movingNames.value].map(Number));
  /** Whether there is something still able to move. */
  readonly alive = computed(() => this.movingNames.value !== '');
  /** Whose motion the same instant starts from: whoever stands still leads nobody. */
  readonly leader = computed(() => {
    const { value: moving } = this.moving;
    return moving.includes(this.wantedLeader.value) ? this.wantedLeader.value : (moving[0] ?? 0);
  });

  /** The same, a digit each, and so equal as long as nobody fails: who shows them is not to be drawn anew with every picture. */
  private readonly movingNames = computed(
    () => this.states.value?.map(({ failure }, at) => (failure ? '' : at)).join('') ?? '',
  );
  private readonly running = computed(
    () => this.alive.value && (this.playing.value || this.held.value !== null || this.pull.value !== null),
  );
  private readonly crew: Crew<SideBySideService>;
  private readonly clock = new Clock();
  private start: (CommonStart & { variants: readonly Variant[] }) | null = null;
  private readonly record = new SideBySideRecord();
  /** What the latest change asks for: one that is overtaken before its turn is not made. */
  private wanted: readonly Variant[] = [];
  private legibleSince = Number.NEGATIVE_INFINITY;

  constructor(createWorker: () => Worker = sideBySideWorker, wasmBinary?: () => Promise<ArrayBuffer>) {
    const onEnd = () =>
      batch(() => {
        this.playing.value = false;
        this.states.value = null;
      });
    this.crew = new Crew(createWorker, onEnd, wasmBinary);
  }

  /** Begins to follow the display's refresh. Returns how to stop, which ends the worker. */
  follow(): () => void {
    let asked = 0;
    const tick = (now: number) => {
      asked = requestAnimationFrame(tick);
      this.clock.drawn(now);
      const steps = this.crew.queue > 0 ? 0 : this.clock.due(now, this.parameters.delta_t);
      if (steps > 0) void this.run(steps);
    };
    const stop = effect(() => {
      cancelAnimationFrame(asked);
      this.clock.rest();
      if (this.running.value) asked = requestAnimationFrame(tick);
      else untracked(() => this.publish());
    });
    return () => {
      stop();
      cancelAnimationFrame(asked);
      this.crew.leave();
    };
  }

  /** Replaces all variants; false when one is refused, after a word about it. The first one's Δt is the clock's. */
  async open(variants: readonly Variant[], start: CommonStart): Promise<boolean> {
    const { scene, pins, from } = start;
    const outcome = await this.crew.ask<Outcome<OpenedSideBySide>>(async (service) =>
      service.open(problemOf(scene), variants, pins, from),
    );
    if (outcome === null || !isTaken(outcome)) return false;
    this.start = { ...start, variants };
    this.take(outcome.value);
    return true;
  }

  /** Other methods or settings; all go on from where they are. False when one is refused, after a word about it: nothing has changed then. */
  async change(variants: readonly Variant[]): Promise<boolean> {
    this.wanted = variants;
    const outcome = await this.crew.ask<Outcome<ChangedSideBySide> | 'overtaken'>(async (service) =>
      this.wanted === variants ? service.change(variants) : 'overtaken',
    );
    if (outcome === 'overtaken') return true;
    if (outcome === null || !isTaken(outcome)) return false;
    const { states, frequency, from } = outcome.value;
    this.start = { ...(this.start as CommonStart), variants };
    this.record.reorder(from);
    batch(() => {
      this.reference.value = Math.max(0, from.indexOf(this.reference.value));
      this.wantedLeader.value = Math.max(0, from.indexOf(this.wantedLeader.value));
      this.instant.value = null;
      this.frequency.value = frequency;
      this.states.value = states;
      this.publish();
    });
    return true;
  }

  /** Measures the others by this variant. */
  measureBy(reference: number): void {
    this.record.forgetDistances();
    this.reference.value = reference;
    this.publish();
  }

  /** Back to where all began, with the pins as they were there. */
  async reset(): Promise<void> {
    this.playing.value = false;
    if (this.start) await this.open(this.start.variants, this.start);
  }

  /** So many time steps at once. */
  async run(steps: number): Promise<void> {
    if (this.crew.queue >= longestQueue || !this.states.value) return;
    const states = await this.crew.ask<VariantState[]>(async (service) =>
      service.run(this.pins.value, this.pull.value, steps),
    );
    if (!states) return;
    const milliseconds = states.reduce((sum, one) => sum + one.milliseconds, 0);
    this.clock.spent(1, milliseconds);
    this.show(states, steps);
  }

  /** One time step by all from the motion of this variant, which is the time step that comes next for it. */
  async sameInstant(leader: number): Promise<void> {
    if (!this.states.value) return;
    this.playing.value = false;
    this.wantedLeader.value = leader; // also when others come to move again by this
    const outcome = await this.crew.ask<Outcome<Instant>>(async (service) =>
      service.sameInstant(leader, this.pins.value, this.pull.value),
    );
    if (outcome === null || !isTaken(outcome)) return;
    this.record.interrupt();
    batch(() => {
      this.show(outcome.value.states, 1);
      this.instant.value = { ...outcome.value, leader };
    });
  }

  /** In all variants. */
  movePin(vertex: number, target: ArrayLike<number>): void {
    const { pinned, targets } = this.pins.value;
    const row = pinned.indexOf(vertex);
    if (row < 0) return;
    const moved = targets.slice();
    moved.set(target, 3 * row);
    this.pins.value = { pinned, targets: moved };
  }

  private get parameters(): Parameters {
    const { variants } = this.start as NonNullable<typeof this.start>; // asked for only while something runs
    return variants[0].parameters;
  }

  private take({ states, frequency, r }: OpenedSideBySide): void {
    const { scene, pins } = this.start as CommonStart;
    this.record.begin(states.length);
    this.clock.reset();
    batch(() => {
      this.scene.value = scene;
      this.r.value = r;
      this.frequency.value = frequency;
      this.pins.value = pins;
      this.states.value = states;
      this.step.value = 0;
      this.reference.value = Math.min(this.reference.value, states.length - 1);
      this.instant.value = null;
      this.publish();
    });
  }

  private show(states: readonly VariantState[], steps: number): void {
    this.record.add(states, steps, this.parameters.delta_t, this.reference.value);
    batch(() => {
      this.states.value = states;
      this.step.value += steps;
      if (states[this.reference.value].failure && this.alive.value)
        this.measureBy(states.findIndex(({ failure }) => !failure)); // who stands still is no measure for the others
      if (!this.running.value || performance.now() >= this.legibleSince + legible_ms) this.publish();
    });
  }

  private publish(): void {
    this.legibleSince = performance.now();
    batch(() => {
      this.energies.value = this.record.energies.map((curve) => curve.slice());
      this.milliseconds.value = this.record.milliseconds.slice();
      this.distances.value = this.record.distances.map((curve) => curve.slice());
    });
  }
}

function sideBySideWorker(): Worker {
  return new Worker(new URL('../solver/side_by_side_worker.ts', import.meta.url), { type: 'module' });
}

function problemOf({ V, E, m }: Scene) {
  return { V, E, m };
}
