import * as z from 'zod/mini';

const text = z.string().check(z.minLength(1));
const positive = z.number().check(z.positive());

/** The JSON of a scene. Fields that are not listed are ignored: files of other programs may carry their own. */
export const sceneFileSchema = z.object({
  obj: text.check(z.describe('Wavefront OBJ file: vertices in metres, springs, polygons')),
  b: z.array(z.int().check(z.gte(1))).check(z.describe('Pinned vertices, counted from 1, each once')),
  k: positive.check(z.describe('N/m, stiffness of every spring')),
  m: z.optional(
    positive.check(z.describe('kg, mass of every vertex; by default a third of each triangle, at 1 kg/m²')),
  ),
  png: z.optional(text.check(z.describe('Picture, laid on by the texture coordinates of the OBJ file'))),
  delta_t: z._default(positive.check(z.describe('s, time step')), 1 / 30),
  iterations: z._default(z.int().check(z.gte(1), z.lte(10_000), z.describe('Iterations of a time step')), 50),
  w: z._default(positive.check(z.describe('N/m, stiffness of the penalty that holds the pinned vertices')), 1e10),
});

export type SceneFile = z.infer<typeof sceneFileSchema>;
