import * as z from 'zod/mini';
import { samplings } from '../curves/sampling.ts';
import { ikMethods } from '../solver/inverse_kinematics.ts';
import { methods, minimisers } from '../solver/module.ts';
import { comparedLimits, mostMethods } from './integrators.ts';
import { kinematicsLimits } from './kinematics.ts';
import { limits } from './limits.ts';
import { languages } from './messages/index.ts';
import type { AppState } from './state.ts';

const within = ({ min, max }: { min: number; max: number }) => z.number().check(z.gte(min), z.lte(max));
const whole = ({ min, max }: { min: number; max: number }) => z.int().check(z.gte(min), z.lte(max));
const index = z.int().check(z.gte(0));
const sceneName = z.string().check(z.regex(/^[\w-]{1,64}$/));
const short = (most: number) => z.string().check(z.maxLength(most));
const formula = short(kinematicsLimits.formula);
const coordinate = within(kinematicsLimits.coordinate);
const place = z.tuple([coordinate, coordinate, coordinate]);
const point = z.tuple([z.number(), z.number(), z.number()]);

/** One schema a part of the state, so that a link with one bad part keeps the others. */
export const stateSchema = {
  version: z.literal(1),
  scene: sceneName,
  parameters: z
    .strictObject({
      k: z.optional(within(limits.k)),
      delta_t: z.optional(within(limits.delta_t)),
      mass_scale: z.optional(within(limits.mass_scale)),
      w: z.optional(within(limits.w)),
      iterations: z.optional(whole(limits.iterations)),
      wind: z.optional(z.boolean()),
      method: z.optional(z.enum(minimisers)),
      stop_gradient: z.optional(within(limits.stop_gradient)),
      stop_decrease: z.optional(within(limits.stop_decrease)),
    })
    .check(z.refine((chosen) => chosen.stop_gradient === undefined || chosen.stop_decrease === undefined)),
  pins: z.nullable(z.array(z.strictObject({ vertex: index, target: z.nullable(point) })).check(z.maxLength(2000))),
  selection: z.strictObject({ spring: z.nullable(index), vertex: z.nullable(index) }),
  view: z.strictObject({
    exaggeration: z.union([z.literal('automatic'), z.number().check(z.gte(1), z.lte(1000))]),
    springs: z.boolean(),
    surface: z.boolean(),
    projector: z.boolean(),
    camera: z.nullable(
      z.strictObject({ position: point, target: point }).check(
        z.refine(({ position, target }) => position.some((x, axis) => x !== target[axis])), // or it would look nowhere
      ),
    ),
    plot: z._default(z.enum(['trace', 'comparison']), 'trace'), // links made before there was a choice name none
  }),
  integrators: z.strictObject({
    scene: sceneName,
    methods: z
      .array(
        z.strictObject({
          method: z.enum(methods),
          iterations: whole(comparedLimits.iterations),
          substeps: whole(comparedLimits.substeps),
        }),
      )
      .check(z.minLength(1), z.maxLength(mostMethods)),
    parameters: z.strictObject({
      k: z.optional(within(comparedLimits.k)),
      mass_scale: z.optional(within(comparedLimits.mass_scale)),
      delta_t: z.optional(within(comparedLimits.delta_t)),
      damping: z.optional(within(comparedLimits.damping)),
      gravity: z.optional(within(comparedLimits.gravity)),
    }),
    poke: z.strictObject({
      stiffness: z.nullable(within(comparedLimits.poke.stiffness)),
      radius: within(comparedLimits.poke.radius),
    }),
  }),
  kinematics: z.strictObject({
    links: z
      .array(
        z.strictObject({
          length: within(kinematicsLimits.length),
          bend: z.nullable(within(kinematicsLimits.bend)),
        }),
      )
      .check(z.minLength(kinematicsLimits.links.min), z.maxLength(kinematicsLimits.links.max)),
    root: place,
    mode: z.enum(['aim', 'draw']),
    target: place,
    curve: z.discriminatedUnion('kind', [
      z.strictObject({ kind: z.enum(['circle', 'square', 'heart', 'triangle', 'star']) }),
      z.strictObject({ kind: z.literal('letters'), text: short(kinematicsLimits.letters) }),
      z.strictObject({ kind: z.literal('formula'), x: formula, y: formula, from: formula, to: formula }),
      z.strictObject({
        kind: z.literal('hand'),
        strokes: z.array(z.array(z.tuple([coordinate, coordinate]))).check(
          z.maxLength(kinematicsLimits.hand.strokes),
          z.refine((strokes) => strokes.flat().length <= kinematicsLimits.hand.points),
        ),
      }),
      z.strictObject({ kind: z.literal('path'), d: short(kinematicsLimits.path) }),
    ]),
    sampling: z.enum(samplings),
    points: whole(kinematicsLimits.points),
    method: z.enum(ikMethods),
    precision: z.enum(['double', 'single']),
    iterations: whole(kinematicsLimits.iterations),
    epsilon: within(kinematicsLimits.epsilon),
    turn: z.nullable(within(kinematicsLimits.turn)),
  }),
  language: z.enum(languages),
  theme: z.enum(['light', 'dark', 'system']),
} satisfies { [K in keyof AppState]: z.ZodMiniType };
