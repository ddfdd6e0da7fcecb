import { sameJson } from '../lib/same_json.ts';
import type { Scene } from '../scene/scene.ts';
import type { Checkpoint } from '../solver/protocol.ts';
import { compareNewton } from './comparison.ts';
import type { IntegratorsSettings } from './integrators.ts';
import type { KinematicsSettings } from './kinematics.ts';
import { limits } from './limits.ts';
import { encodeLink, type Link } from './link.ts';
import type { Language } from './messages/index.ts';
import { language } from './messages/index.ts';
import { dismissErrors, notify } from './notices.ts';
import { route, springsRoute } from './route.ts';
import { findScene, openedScenes, openFiles } from './scene_library.ts';
import { seekScene } from './seek_scene.ts';
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
import { reading } from './work.ts';

type Find = (signal: AbortSignal) => Promise<Scene>;
/** What opening a scene makes of the state. */
type Change = Parameters<Session['open']>[1];

/** Everything a reader can do. The only writer of the state; views call these and nothing else. */
export class Actions {
  private readonly session: Session;

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
  /** To the end of another time step; a later one is computed on the way. */
  goToStep(step: number): void {
    this.pausedAnd({ kind: 'go_to_step', step });
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
    const { spring } = state.value.selection;
    const touches = spring !== null && (E[2 * spring] === vertex || E[2 * spring + 1] === vertex);
    const first = Math.floor(E.indexOf(vertex) / 2); // of the springs at this vertex; negative when there is none
    this.change({ selection: { spring: touches || first < 0 ? spring : first, vertex } });
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

  /** What the integrators lab compares; one equal to what it compares already changes nothing. */
  setIntegrators(change: Partial<IntegratorsSettings>): void {
    const integrators = { ...state.value.integrators, ...change };
    if (!sameJson(integrators, state.value.integrators)) this.change({ integrators });
  }

  /** What the kinematics lab shows, likewise. */
  setKinematics(change: Partial<KinematicsSettings>): void {
    const kinematics = { ...state.value.kinematics, ...change };
    if (!sameJson(kinematics, state.value.kinematics)) this.change({ kinematics });
  }

  async copyLink(): Promise<void> {
    try {
      await navigator.clipboard.writeText(location.href.replace(/#.*/, '') + encodeLink(route.value, state.value));
      const name = route.value.page === 'integrators' ? state.value.integrators.scene : state.value.scene;
      const own = openedScenes.value.some((opened) => opened.name === name);
      if (route.value.page === 'lesson') notify('info', 'page.header.linkToLessonCopied');
      else if (route.value.page === 'kinematics') notify('info', 'page.header.linkToArmCopied');
      else notify('info', own ? 'page.header.linkWithoutFile' : 'page.header.linkCopied', { name });
    } catch {
      notify('info', 'page.header.linkFailed'); // clipboards need a secure page and permission
    }
  }

  /** Opens a scene from files that the reader chose or dropped. */
  async openFiles(files: readonly File[]): Promise<void> {
    if (route.value.page !== 'integrators') return void (await this.openAfresh((signal) => openFiles(files, signal)));
    const found = await seekScene((signal) => openFiles(files, signal));
    if (found) this.compareOn(found.name);
  }

  /** Opens a scene of the library with the scene's own parameters and pins. */
  async openScene(name: string): Promise<void> {
    if (route.value.page === 'integrators') this.compareOn(name);
    else await this.openAfresh((signal) => findScene(name, signal));
  }

  /** Opens a scene of the library, its own parameters changed by these, at the end of a time step. */
  async openStep(name: string, parameters: AppState['parameters'], step: number): Promise<void> {
    this.pause();
    if (await this.openAfresh((signal) => findScene(name, signal), parameters)) this.goToStep(step);
  }

  /** Goes where a link leads. What the lab already shows goes on as it stood. */
  async follow({ route: to, state: wanted }: Link): Promise<void> {
    route.value = to; // before a scene is read: its end must not bring back a reader who has gone on
    if (to.page !== 'springs') {
      this.pause();
      this.setLanguage(wanted.language);
      this.setTheme(wanted.theme);
      if (to.page === 'integrators') this.setIntegrators(wanted.integrators);
      if (to.page === 'kinematics') this.setKinematics(wanted.kinematics);
    } else if (!frame.value) {
      language.value = wanted.language;
      state.value = wanted; // start_lab.ts opens it
    } else if (encodeLink(to, wanted) !== encodeLink(to, state.value)) await this.restore(wanted);
  }

  /** Makes `wanted` the state, as from a link. False when its scene cannot be opened; everything then stays as it was. */
  async restore(wanted: AppState): Promise<boolean> {
    return this.open(
      (signal) => findScene(wanted.scene, signal),
      () => {
        language.value = wanted.language;
        return wanted;
      },
    );
  }

  /** Shows in the lab what stands somewhere else on the page, at the same moment. */
  async openMoment(
    { scene: name, ...settings }: Pick<AppState, 'scene' | 'parameters' | 'pins' | 'selection'>,
    from: Checkpoint,
  ): Promise<void> {
    dismissErrors();
    this.pause();
    const asked = route.value;
    const opened = await this.open(
      (signal) => findScene(name, signal),
      () => ({ scene: name, ...settings, view: { ...state.value.view, camera: null } }),
      from,
    );
    if (opened && route.value === asked) route.value = springsRoute;
  }

  /** Gives up what the reader waits for: a scene's files, or else the solver's request. */
  cancel(): void {
    if (reading.value) {
      reading.value.abort();
      notify('info', 'page.notice.cancelled');
    } else this.session.cancel();
  }

  private compareOn(scene: string): void {
    dismissErrors();
    this.change({ integrators: { ...state.value.integrators, scene, parameters: {} } });
  }

  private async openAfresh(find: Find, parameters: AppState['parameters'] = {}): Promise<boolean> {
    dismissErrors();
    return this.open(find, ({ name }) => ({
      scene: name,
      parameters,
      pins: null,
      selection: defaultState.selection,
      view: { ...state.value.view, camera: null },
    }));
  }

  private async open(find: Find, change: (found: Scene) => Change, from: Checkpoint | null = null): Promise<boolean> {
    const found = await seekScene(find);
    if (!found) return false;
    const wanted = change(found);
    const sensible = {
      ...wanted,
      pins: sensiblePins(found, wanted.pins),
      selection: selectionOn(found, wanted.selection),
    };
    return this.session.open(found, sensible, from);
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
  let hanging = 0;
  while (hanging < springCount && held.has(s.E[2 * hanging]) === held.has(s.E[2 * hanging + 1])) hanging++;
  const e = spring !== null && spring < springCount ? spring : hanging % springCount;
  const [i, j] = [s.E[2 * e], s.E[2 * e + 1]];
  return { spring: e, vertex: vertex !== null && vertex < s.m.length ? vertex : held.has(i) ? j : i };
}
