import * as z from 'zod/mini';

const text = z.string().check(z.minLength(1));
const positive = z.number().check(z.positive());

/** The JSON of a scene, but for what `namesOneShape` asks. Fields that are not listed are ignored: files of other programs may carry their own. */
export const sceneFileSchema = z.object({
  obj: z.optional(text.check(z.describe('Wavefront OBJ file: vertices in metres, springs, polygons'))),
  mesh: z.optional(text.check(z.describe('In place of obj, Medit mesh as text: vertices in metres, tetrahedra'))),
  b: z.array(z.int().check(z.gte(1))).check(z.describe('Pinned vertices, counted from 1, each once')),
  k: positive.check(z.describe('N/m, stiffness of every spring')),
  m: z.optional(
    positive.check(
      z.describe(
        'kg, mass of every vertex; by default a quarter of each tetrahedron, at 1 kg/m³, or else a third of each triangle, at 1 kg/m²',
      ),
    ),
  ),
  png: z.optional(text.check(z.describe('Picture, laid on by the texture coordinates of the OBJ file'))),
  delta_t: z._default(positive.check(z.describe('s, time step')), 1 / 30),
  iterations: z._default(z.int().check(z.gte(1), z.lte(10_000), z.describe('Iterations of a time step')), 50),
  w: z._default(positive.check(z.describe('N/m, stiffness of the penalty that holds the pinned vertices')), 1e10),
  gravity: z._default(z.number().check(z.gte(0), z.describe('m/s², downwards')), 9.8),
  damping: z._default(z.number().check(z.gte(0), z.describe('N·s/m, of the dashpot along every spring')), 0),
});

type Fields = z.infer<typeof sceneFileSchema>;
export type SceneFile = Fields & ({ obj: string; mesh?: undefined } | { obj?: undefined; mesh: string });

export function namesOneShape(fields: Fields): fields is SceneFile {
  return (fields.obj === undefined) !== (fields.mesh === undefined);
}

/** The name of the file of a scene's vertices. */
export function shapeFile({ obj, mesh }: SceneFile): string {
  return mesh === undefined ? obj : mesh;
}
