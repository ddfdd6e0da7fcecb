import type { Scene } from '../scene/scene.ts';
import type { Method, Parameters } from '../solver/module.ts';
import { sceneParameters } from '../solver/scene_parameters.ts';
import type { Variant } from '../solver/side_by_side.ts';

/** One of the methods compared, and how hard it works at a time step. */
export interface MethodChoice {
  method: Method;
  /** K, of a method that iterates. */
  iterations: number;
  /** N: a time step is N steps of Δt/N. */
  substeps: number;
}

/** What the integrators lab compares, on what and with which numbers: part of the saved state. */
export interface IntegratorsSettings {
  scene: string;
  /** One to four. */
  methods: readonly MethodChoice[];
  /** What differs from the scene's own values. */
  parameters: Partial<Record<ComparedParameter, number>>;
  poke: Poke;
}

/** How the pointer takes hold of a surface. */
export interface Poke {
  /** N/m: of the spring at each vertex that is held. Null: k. */
  stiffness: number | null;
  /** As a share of the scene's size: how far around the pointer vertices are taken hold of. */
  radius: number;
}

/** What all methods compared have in common and the reader can change. Units as in solver/module.ts. */
export const comparedParameters = ['k', 'mass_scale', 'delta_t', 'damping', 'gravity'] as const;
export type ComparedParameter = (typeof comparedParameters)[number];

/** What a link may ask for. */
export const comparedLimits = {
  k: { min: 1, max: 1e7 },
  mass_scale: { min: 1e-2, max: 1e2 },
  delta_t: { min: 1e-4, max: 1 },
  damping: { min: 0, max: 1e4 },
  gravity: { min: 0, max: 100 },
  iterations: { min: 1, max: 1000 },
  substeps: { min: 1, max: 1000 },
  poke: { stiffness: { min: 1, max: 1e7 }, radius: { min: 0.01, max: 0.5 } },
} as const;

/** At most so many side by side. */
export const mostMethods = 4;

/** Newton's method ends by itself where E falls no further: long before. */
export const toConvergence = comparedLimits.iterations.max;

/** Methods that make a time step without iterating; the others solve it, and their steps may stay as long as they are. */
export const oneStepMethods: readonly Method[] = ['forward-euler', 'symplectic-euler', 'linearly-implicit'];
export const explicitMethods: readonly Method[] = ['forward-euler', 'symplectic-euler'];

export const defaultIntegrators: IntegratorsSettings = {
  scene: 'rabbit',
  methods: [
    { method: 'linearly-implicit', iterations: 1, substeps: 1 },
    { method: 'local-global', iterations: 10, substeps: 1 },
  ],
  parameters: {},
  poke: { stiffness: null, radius: 0.06 },
};

/** Just what the lesson's two explicit methods do on a scene that is too stiff for them. */
export const explicitIntegrators: IntegratorsSettings = {
  ...defaultIntegrators,
  scene: 'cloth',
  methods: [
    { method: 'forward-euler', iterations: 1, substeps: 1 },
    { method: 'symplectic-euler', iterations: 1, substeps: 1 },
    { method: 'linearly-implicit', iterations: 1, substeps: 1 },
  ],
};

/** The scene's own values with the reader's. */
export function comparedParametersOn(scene: Scene, changes: IntegratorsSettings['parameters']): Parameters {
  return { ...sceneParameters(scene), ...changes, path: 'fast' }; // held vertices are where they are held, exactly
}

/** What runs side by side. */
export function variantsOn(scene: Scene, { methods, parameters }: IntegratorsSettings): Variant[] {
  const common = comparedParametersOn(scene, parameters);
  return methods.map(({ method, iterations, substeps }) => ({
    parameters: { ...common, method, iterations: oneStepMethods.includes(method) ? 1 : iterations },
    substeps,
    mistake: 'none',
  }));
}
