import { computed, signal } from '@preact/signals';
import { noScene, type Scene } from '../scene/scene.ts';
import type { Frame } from '../solver/frame.ts';
import type { MinimisingParameters } from '../solver/module.ts';
import type { Pins } from '../solver/protocol.ts';
import { sceneParameters } from '../solver/scene_parameters.ts';
import type { Figure } from './figure.ts';
import { defaultIntegrators, type IntegratorsSettings } from './integrators.ts';
import { defaultKinematics, type KinematicsSettings } from './kinematics.ts';
import type { Language } from './messages/index.ts';

/** Everything worth saving: what a link, a preset or a fixture holds. Plain JSON, checked by schema.ts. */
export interface AppState {
  version: 1;
  /** Name of a scene in the library, or of one the reader opened from files. */
  scene: string;
  /** What differs from the scene's own parameters. */
  parameters: Partial<Adjustable>;
  /** Null: the scene's own pins at their rest positions. */
  pins: Pin[] | null;
  selection: Selection;
  view: ViewOptions;
  integrators: IntegratorsSettings;
  kinematics: KinematicsSettings;
  language: Language;
  theme: 'light' | 'dark' | 'system';
}

/** The parameters a reader can change. Units as in solver/module.ts. At most one of the two stopping rules is in force. */
export type Adjustable = Pick<
  MinimisingParameters,
  'k' | 'delta_t' | 'mass_scale' | 'w' | 'iterations' | 'wind' | 'method' | StoppingRule
>;

/** What may end a time step before its K-th iteration; 0 where it may not. */
export type StoppingRule = 'stop_gradient' | 'stop_decrease';

export interface Pin {
  vertex: number;
  /** m. Null: held at its rest position. */
  target: [number, number, number] | null;
}

export interface Selection {
  spring: number | null;
  vertex: number | null;
}

export interface ViewOptions {
  /** What the two views multiply small changes by, so that they can be seen. */
  exaggeration: 'automatic' | number;
  springs: boolean;
  surface: boolean;
  /** Bigger type, secondary controls folded away. */
  projector: boolean;
  camera: Camera | null;
  /** This time step half-step by half-step, or by every method. */
  plot: 'trace' | 'comparison';
}

/** Metres; up is +y. */
export interface Camera {
  position: [number, number, number];
  target: [number, number, number];
}

export const defaultState: AppState = {
  version: 1,
  scene: 'net',
  parameters: {},
  pins: null,
  selection: { spring: null, vertex: null },
  view: { exaggeration: 'automatic', springs: true, surface: true, projector: false, camera: null, plot: 'trace' },
  integrators: defaultIntegrators,
  kinematics: defaultKinematics,
  language: 'en',
  theme: 'system',
};

/** The one app state. Written by actions.ts alone. */
export const state = signal<AppState>(defaultState);

// What passes: not part of the saved state, and rebuilt from it.
export const scene = signal<Scene>(noScene);
/** #E, m: rest lengths, from the solver. */
export const r = signal<Float64Array>(new Float64Array(0));
/** What words and numbers show: while playing not every frame, because nobody reads so fast. */
export const frame = signal<Frame | null>(null);
/** Every frame, for the picture. */
export const liveFrame = signal<Frame | null>(null);
/** The latest time step that the clock has come to since the scene was opened or reset: the end of the line of time. */
export const furthestStep = signal(1);
export const playing = signal(false);
/** A pin being dragged follows the pointer whether or not the clock runs. */
export const dragging = signal<number | null>(null);

// Computed one by one, so that what follows a part does not hear of the others.
const chosenParameters = computed(() => state.value.parameters);
const chosenPins = computed(() => state.value.pins);
const selection = computed(() => state.value.selection);
export const selectedVertex = computed(() => selection.value.vertex);

/** The parameters in force. */
export const parameters = computed(() => parametersOn(scene.value, chosenParameters.value));

/** The pins in force. */
export const pins = computed(() => pinsOn(scene.value, chosenPins.value));

/** The lab's simulation, for what formulas, matrices and code show of one. */
export const labFigure: Figure = { scene, r, frame, parameters, selection };

/** The scene's own parameters with the reader's changes. */
export function parametersOn(s: Scene, chosen: AppState['parameters']): MinimisingParameters {
  return {
    ...sceneParameters(s),
    damping: 0, // what the lab shows, from Q p = b to the solvers with mistakes, has no dashpots
    ...chosen,
    path: chosen.w === undefined ? 'fast' : 'plain', // only the plain path has a penalty: who chooses w wants to see what it does
  };
}

/** The reader's pins, or the scene's own at rest. */
export function pinsOn(s: Scene, chosen: AppState['pins']): Pins {
  const list: Pin[] = chosen ?? Array.from(s.pinned, (vertex) => ({ vertex, target: null }));
  return {
    pinned: Int32Array.from(list, (pin) => pin.vertex),
    targets: Float64Array.from(list.flatMap(({ vertex, target }) => target ?? restPosition(s, vertex))),
  };
}

function restPosition(s: Scene, vertex: number): number[] {
  return Array.from(s.V.subarray(3 * vertex, 3 * vertex + 3));
}
