import type { Scene } from '../scene/scene.ts';
import type { Checkpoint } from '../solver/protocol.ts';
import { compareNewton } from './comparison.ts';
import { limits } from './limits.ts';
import { encodeLink, type Link } from './link.ts';
import type { Language } from './messages/index.ts';
import { language } from './messages/index.ts';
import { dismissErrors, notify } from './notices.ts';
import { route } from './route.ts';
import { findScene, openedScenes, openFiles, SceneProblem } from './scene_library.ts';
import type { Session } from './session.ts';
import {
  type Adjustable,
  type AppState,
  defaultState,
  dragging,
  frame,
  type Pin,
  pins,
  playing,
  type Selection,
  type StoppingRule,
  scene,
  state,
  type ViewOptions,
} from './state.ts';

/** Everything a reader can do. The only writer of the state; views call these and nothing else. */
export class Actions {
  private readonly session: Session;

  private openings = 0;

  constructor(session: Session) {
    this.session = session;
  }

  // The clock and the cursor.
  play(): void {
    playing.value = true;
  }
  pause(): void {
    playing.value = false;
  }
  togglePlaying(): void {
    playing.value = !playing.value;
  }
  /** Stops at the first local step of the time step just played: where the springs are torn most. */
  lookInside(): void {
    this.seek(1);
  }
  nextHalfStep(): void {
    this.pausedAnd({ kind: 'next_half_step' });
  }
  previousHalfStep(): void {
    this.pausedAnd({ kind: 'previous_half_step' });
  }
  nextStep(): void {
    this.pausedAnd({ kind: 'next_step' });
  }
  previousStep(): void {
    this.pausedAnd({ kind: 'previous_step' });
  }
  seek(half_step: number): void {
    this.pausedAnd({ kind: 'seek', half_step });
  }
  /** Back to rest, every pin held where it rests; parameters and the set of pins stay. */
  reset(): void {
    if (state.value.pins) this.change({ pins: state.value.pins.map((pin) => ({ ...pin, target: null })) });
    this.session.order({ kind: 'reset' });
  }
  private pausedAnd(command: Parameters<Session['order']>[0]): void {
    playing.value = false;
    this.session.order(command);
  }

  // Parameters.
  setParameter<Name extends Exclude<keyof Adjustable, StoppingRule>>(name: Name, value: Adjustable[Name]): void {
    this.change({ parameters: { ...state.value.parameters, [name]: clamped(name, value) } });
  }
  /** Null: a time step always makes K iterations. */
  setStoppingRule(rule: StoppingRule | null, epsilon = 0): void {
    const { stop_gradient: _, stop_decrease: __, ...others } = state.value.parameters;
    this.change({ parameters: rule ? { ...others, [rule]: clamped(rule, epsilon) } : others });
  }
  resetParameter(name: keyof Adjustable): void {
    const { [name]: _, ...others } = state.value.parameters;
    this.change({ parameters: others });
  }
  resetParameters(): void {
    this.change({ parameters: {} });
  }

  // Pins.
  /** Pins a vertex where `at` says, or frees it. */
  togglePin(vertex: number, at: [number, number, number]): void {
    const now = this.listedPins();
    const without = now.filter((pin) => pin.vertex !== vertex);
    this.change({ pins: without.length < now.length ? without : [...now, { vertex, target: at }] });
  }
  movePin(vertex: number, target: [number, number, number]): void {
    this.change({ pins: this.listedPins().map((pin) => (pin.vertex === vertex ? { vertex, target } : pin)) });
  }
  resetPins(): void {
    this.change({ pins: null });
  }
  beginDrag(vertex: number): void {
    dragging.value = vertex;
  }
  endDrag(): void {
    dragging.value = null;
  }
  private listedPins(): Pin[] {
    const { pinned, targets } = pins.value;
    return (
      state.value.pins ??
      Array.from(pinned, (vertex, row) => ({
        vertex,
        target: Array.from(targets.subarray(3 * row, 3 * row + 3)) as [number, number, number],
      }))
    );
  }

  // What is shown.
  /** Selects a spring and with it one of its ends, or a vertex and with it one of its springs, so that both equations speak of the same place. */
  selectSpring(spring: number): void {
    const { E } = scene.value;
    const ends = [E[2 * spring], E[2 * spring + 1]];
    const { vertex } = state.value.selection;
    const free = ends.find((end) => !pins.value.pinned.includes(end)) ?? ends[0];
    this.change({ selection: { spring, vertex: vertex !== null && ends.includes(vertex) ? vertex : free } });
  }
  selectVertex(vertex: number): void {
    const { E } = scene.value;
    const touches = (e: number) => E[2 * e] === vertex || E[2 * e + 1] === vertex;
    const { spring } = state.value.selection;
    if (spring !== null && touches(spring)) this.change({ selection: { spring, vertex } });
    else {
      const first = Array.from({ length: E.length / 2 }, (_, e) => e).find(touches);
      this.change({ selection: { spring: first ?? spring, vertex } });
    }
  }
  setView(view: Partial<ViewOptions>): void {
    this.change({ view: { ...state.value.view, ...view } });
  }
  /** Newton's method joins the comparison of this time step. */
  compareNewton(): void {
    compareNewton();
  }
  setTheme(theme: AppState['theme']): void {
    this.change({ theme });
  }
  setLanguage(next: Language): void {
    language.value = next;
    this.change({ language: next });
  }

  async copyLink(): Promise<void> {
    try {
      await navigator.clipboard.writeText(location.href.replace(/#.*/, '') + encodeLink(route.value, state.value));
      const own = openedScenes.value.some(({ name }) => name === state.value.scene);
      if (route.value.page === 'lesson') notify('info', 'page.header.linkToLessonCopied');
      else notify('info', own ? 'page.header.linkWithoutFile' : 'page.header.linkCopied', { name: state.value.scene });
    } catch {
      notify('info', 'page.header.linkFailed'); // clipboards need a secure page and permission
    }
  }

  /** Opens a scene from files that the reader chose or dropped. */
  async openFiles(files: readonly File[]): Promise<void> {
    dismissErrors();
    await this.reporting(async () => {
      await this.openScene((await openFiles(files)).name);
    });
  }

  /** Opens a scene of the library with the scene's own parameters and pins. */
  async openScene(name: string): Promise<void> {
    dismissErrors();
    await this.open(name, () => ({
      scene: name,
      parameters: {},
      pins: null,
      selection: defaultState.selection,
      view: { ...state.value.view, camera: null },
    }));
  }

  /** Goes where a link leads. What the lab already shows goes on as it stood. */
  async follow({ route: to, state: wanted }: Link): Promise<void> {
    if (to.page === 'lesson') {
      this.pause();
      this.setLanguage(wanted.language);
      this.setTheme(wanted.theme);
    } else if (!frame.value) {
      language.value = wanted.language;
      state.value = wanted; // start_lab.ts opens it
    } else if (encodeLink(to, wanted) !== encodeLink(to, state.value)) await this.restore(wanted);
    route.value = to;
  }

  /** Makes `wanted` the state, as from a link. False when its scene cannot be opened; everything then stays as it was. */
  async restore(wanted: AppState): Promise<boolean> {
    return this.open(wanted.scene, () => {
      language.value = wanted.language;
      return wanted;
    });
  }

  /** Shows in the lab what stands somewhere else on the page, at the same moment. */
  async openMoment(
    { scene: name, ...settings }: Pick<AppState, 'scene' | 'parameters' | 'pins' | 'selection'>,
    from: Checkpoint,
  ): Promise<void> {
    dismissErrors();
    this.pause();
    const change = () => ({ scene: name, ...settings, view: { ...state.value.view, camera: null } });
    if (await this.open(name, change, from)) route.value = { page: 'springs' };
  }

  /** Opens the scene of that name, unless another was asked for while its files were on their way. */
  private async open(
    name: string,
    change: () => Pick<AppState, 'parameters' | 'pins' | 'selection'> & Partial<AppState>,
    from: Checkpoint | null = null,
  ): Promise<boolean> {
    this.openings += 1;
    const mine = this.openings;
    let opened = false;
    await this.reporting(async () => {
      const found = await findScene(name);
      if (mine !== this.openings) return;
      const wanted = change();
      const sensible = {
        ...wanted,
        pins: sensiblePins(found, wanted.pins),
        selection: selectionOn(found, wanted.selection),
      };
      opened = await this.session.open(found, sensible, from);
    });
    return opened;
  }

  private async reporting(open: () => Promise<void>): Promise<void> {
    try {
      await open();
    } catch (problem) {
      if (!(problem instanceof SceneProblem)) throw problem;
      notify('error', problem.key, problem.params);
    }
  }

  private change(part: Partial<AppState>): void {
    state.value = { ...state.value, ...part };
  }
}

function clamped<Name extends keyof Adjustable>(name: Name, value: Adjustable[Name]): Adjustable[Name] {
  if (typeof value !== 'number') return value;
  const { min, max } = limits[name as keyof typeof limits]; // the names of all that are numbers
  return Math.min(max, Math.max(min, value)) as Adjustable[Name];
}

/** Pins that make sense on this scene: none of them double, missing or absurdly far; otherwise the scene's own, and a word about it. */
function sensiblePins({ m, V }: Scene, wanted: Pin[] | null): Pin[] | null {
  if (!wanted) return null;
  const farthest = 1000 * V.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  const sensible = wanted.every(
    ({ vertex, target }) => vertex < m.length && (target ?? []).every((x) => Math.abs(x) <= farthest),
  );
  if (sensible && new Set(wanted.map(({ vertex }) => vertex)).size === wanted.length) return wanted;
  notify('error', 'page.errors.linkPart', { part: 'pins', value: JSON.stringify(wanted).slice(0, 60) });
  return null;
}

/** What of a selection exists on this scene; where nothing is chosen, a spring that hangs from a pin, which shows the most. */
function selectionOn(s: Scene, { spring, vertex }: Selection): Selection {
  const springCount = s.E.length / 2;
  const held = new Set(s.pinned);
  const hanging = Array.from({ length: springCount }, (_, e) => e).find(
    (e) => held.has(s.E[2 * e]) !== held.has(s.E[2 * e + 1]),
  );
  const e = spring !== null && spring < springCount ? spring : (hanging ?? 0);
  const [i, j] = [s.E[2 * e], s.E[2 * e + 1]];
  return { spring: e, vertex: vertex !== null && vertex < s.m.length ? vertex : held.has(i) ? j : i };
}
