import { batch, effect, untracked } from '@preact/signals';
import type { Scene } from '../scene/scene.ts';
import { SolverCancelled, type SolverClient, SolverCrash } from '../solver/client.ts';
import type { Frame } from '../solver/frame.ts';
import type { Minimiser, Status } from '../solver/module.ts';
import type { Checkpoint, Command, Request } from '../solver/protocol.ts';
import { Clock } from './clock.ts';
import { compared, comparisonRequest, missingMethod, timeStep } from './comparison.ts';
import { notifyRefusal } from './explanation.ts';
import { answered, askMatrices, linearSystem, type MatrixQuestion, matrixWishes, missingMatrices } from './matrices.ts';
import { iterationTime, playedStep } from './measurements.ts';
import { notify } from './notices.ts';
import {
  type AppState,
  dragging,
  frame,
  furthestStep,
  liveFrame,
  parameters,
  parametersOn,
  pins,
  pinsOn,
  playing,
  r,
  scene,
  selectedVertex,
  state,
} from './state.ts';
import { solving } from './work.ts';

/** Clicks that may wait for the solver; more are a held key, and only delay what the reader sees. */
const longestQueue = 4;

/** How long numbers stand while playing. */
const legible_ms = 200;

/** How often playing waits for a measurement. */
const profilePeriod_ms = 1000;

/**
 * Drives the solver from the state: at most one request in flight, made from whatever the state is when it is sent. Sliders and drags therefore
 * coalesce by themselves (the last value wins), and a refused value puts the last accepted ones back.
 */
export class Session {
  private readonly clock = new Clock();
  private readonly queue: Command[] = [];
  private current: Promise<void> | null = null;
  /** The state has changed since the last request. */
  private stale = false;
  /** The last request failed and nothing has changed since: asking again would fail again. */
  private halted = false;
  /** When numbers changed last, ms. */
  private legibleSince = Number.NEGATIVE_INFINITY;
  /** When what an iteration takes was last measured, ms. */
  private profiled = Number.NEGATIVE_INFINITY;
  private accepted: Pick<AppState, 'parameters' | 'pins'> = { parameters: {}, pins: null };

  private readonly client: SolverClient;

  constructor(client: SolverClient) {
    this.client = client;
  }

  /** Begins to follow the state and the display's refresh. */
  start(): void {
    effect(() => {
      // Reading them subscribes: whatever they become, the picture has to follow.
      void [parameters.value, pins.value, selectedVertex.value, playing.value, dragging.value];
      untracked(() => {
        this.stale = true;
        this.halted = false;
        if (!playing.value) frame.value = liveFrame.value;
        void this.pump();
      });
    });
    effect(() => {
      void matrixWishes.value; // another wish is not what was given up
      this.halted = false;
    });
    effect(() => {
      if (missingMethod.value || missingMatrices.value) untracked(() => void this.pump());
    });
    const tick = (now: number) => {
      requestAnimationFrame(tick);
      this.clock.drawn(now);
      if (!playing.value) return this.clock.rest();
      if (this.current) return;
      const steps = this.clock.due(now, parameters.value.delta_t);
      if (steps > 0) this.order({ kind: 'play', steps });
    };
    requestAnimationFrame(tick);
  }

  /** Opens a scene, at rest or where `from` says, and makes `change` part of the state. False, and everything as it was, when the solver refuses it. */
  async open(
    next: Scene,
    change: Pick<AppState, 'parameters' | 'pins' | 'selection'> & Partial<AppState>,
    from: Checkpoint | null = null,
  ): Promise<boolean> {
    while (this.current) await this.current;
    let opened = false;
    await this.alone(
      this.openNow(next, change, from).then((result) => {
        opened = result;
      }),
    );
    void this.pump();
    return opened;
  }

  /** Gives up the request in flight: everything stays as it was before. */
  cancel(): void {
    solving.value = null; // what follows is the way back
    this.client.cancel();
  }

  private async openNow(
    next: Scene,
    change: Parameters<Session['open']>[1],
    from: Checkpoint | null,
  ): Promise<boolean> {
    const request: Request = {
      parameters: parametersOn(next, change.parameters),
      pins: pinsOn(next, change.pins),
      command: { kind: 'stay' },
      selectedVertex: change.selection.vertex,
      wholeTrace: false,
      profile: false,
    };
    try {
      const outcome = await this.client.open(next, request, from);
      if (outcome.ok) {
        this.accepted = { parameters: change.parameters, pins: change.pins };
        this.queue.length = 0;
        this.clock.reset();
        // All at once: nobody may see one scene's springs with another's positions.
        batch(() => {
          scene.value = next;
          state.value = { ...state.value, ...change };
          r.value = outcome.value.r;
          liveFrame.value = outcome.value.frame;
          frame.value = outcome.value.frame;
          furthestStep.value = outcome.value.frame.step;
        });
        return true;
      }
      this.explain(outcome.status);
    } catch (reason) {
      this.lost(reason);
    }
    return false;
  }

  /** Asks for a move of the cursor. */
  order(command: Command): void {
    this.halted = false;
    if (command.kind === 'reset') this.queue.length = 0; // from wherever those would have led
    if (this.replaces(command)) this.queue.pop();
    if (this.queue.length < longestQueue) this.queue.push(command);
    void this.pump();
  }

  /** A slider being dragged asks for many places on the way to one. */
  private replaces({ kind }: Command): boolean {
    return (kind === 'seek' || kind === 'go_to_step') && this.queue.at(-1)?.kind === kind;
  }

  private async pump(): Promise<void> {
    while (!this.current && frame.value) {
      const command = this.next();
      const method = missingMethod.value;
      const question = missingMatrices.value;
      if (command) await this.alone(this.run(this.request(command)));
      else if (method && this.idle()) await this.alone(this.compare(method));
      else if (question && this.idle()) await this.alone(this.answer(question));
      else return;
    }
  }

  private async alone(request: Promise<void>): Promise<void> {
    this.current = request;
    try {
      await request;
    } finally {
      this.current = null;
      solving.value = null;
    }
  }

  private next(): Command | null {
    const ordered = this.queue.shift();
    if (ordered) return ordered;
    if (playing.value || this.halted) return null; // while playing, the next steps carry the changes
    return this.stale || this.unfinishedTrace() ? { kind: 'stay' } : null;
  }

  /** Paused with nothing else to do: the rest of this time step's trace can be computed for the plot. */
  private unfinishedTrace(): boolean {
    const f = frame.value;
    return f !== null && dragging.value === null && f.events.length <= f.last_half_step;
  }

  private idle(): boolean {
    return !playing.value && dragging.value === null && !this.halted;
  }

  private async compare(method: Minimiser): Promise<void> {
    const [asked, settings] = [timeStep.value, state.value];
    try {
      compared(asked, method, await this.client.compare(comparisonRequest(method)));
    } catch (reason) {
      this.lost(reason);
      this.fallBack(settings);
    }
  }

  private async answer(question: MatrixQuestion): Promise<void> {
    const [asked, settings] = [linearSystem.value, state.value];
    try {
      answered(asked, await askMatrices(this.client, question));
    } catch (reason) {
      this.lost(reason);
      this.fallBack(settings);
    }
  }

  private request(command: Command): Request {
    const wholeTrace = command.kind === 'stay' && !this.stale && this.unfinishedTrace();
    const profile = wholeTrace || (command.kind === 'play' && performance.now() > this.profiled + profilePeriod_ms);
    if (profile) this.profiled = performance.now();
    this.stale = false;
    return {
      parameters: parameters.value,
      pins: pins.value,
      command,
      selectedVertex: selectedVertex.value,
      wholeTrace,
      profile,
    };
  }

  private async run(request: Request): Promise<void> {
    const settings = { parameters: state.value.parameters, pins: state.value.pins };
    try {
      const outcome = await this.client.run(request);
      if (outcome.ok) {
        this.accepted = settings;
        this.show(outcome.value.frame, request.command);
        this.measured(request.command, outcome.value.frame);
      } else {
        this.explain(outcome.status);
        this.fallBack(settings);
      }
    } catch (reason) {
      this.lost(reason);
      this.fallBack(settings);
    }
  }

  private show(next: Frame, command: Command): void {
    const now = performance.now();
    const legible = !playing.value || now >= this.legibleSince + legible_ms;
    if (legible) this.legibleSince = now;
    batch(() => {
      liveFrame.value = next;
      if (legible) frame.value = next;
      furthestStep.value = command.kind === 'reset' ? next.step : Math.max(next.step, furthestStep.value);
    });
  }

  private measured(command: Command, { milliseconds, profile }: Frame): void {
    if (profile) iterationTime.value = profile;
    if (command.kind !== 'play') return;
    this.clock.spent(command.steps, milliseconds);
    playedStep.add(milliseconds / command.steps, performance.now());
  }

  /** Puts the last accepted parameters and pins back, unless it was those that failed or the reader has moved on. */
  private fallBack(failed: Pick<AppState, 'parameters' | 'pins'>): void {
    playing.value = false;
    this.queue.length = 0;
    const { parameters: p, pins: q } = state.value;
    if (p !== failed.parameters || q !== failed.pins) return; // what was chosen since is asked for next
    this.stale = false;
    this.halted = true;
    if (p !== this.accepted.parameters || q !== this.accepted.pins) state.value = { ...state.value, ...this.accepted };
  }

  /** A request that has no outcome; the client has restored what was before it. */
  private lost(reason: unknown): void {
    if (reason instanceof SolverCancelled) notify('info', 'page.notice.cancelled');
    else if (reason instanceof SolverCrash) notify('error', 'page.errors.crash', { reason: reason.message });
    else throw reason;
  }

  private explain(status: Status): void {
    notifyRefusal(status);
  }
}
