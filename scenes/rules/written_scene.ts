import { encode } from 'fast-png';
import { jsonText } from './json_text.ts';
import type { MadeScene } from './made_scene.ts';

/** The files of a scene: name → content. */
export function writtenScene(scene: MadeScene): Map<string, string | Uint8Array> {
  const { name, shape } = scene;
  const files = new Map<string, string | Uint8Array>([
    [`${name}.json`, sceneText(scene)],
    [`${name}.obj`, objText(scene)],
  ]);
  if ('picture' in shape) {
    const { width, height, pixels } = shape.picture;
    files.set(`${name}.png`, encode({ width, height, data: pixels, channels: 3, depth: 8 }, { zlib: { level: 9 } }));
  }
  return files;
}

function sceneText({ name, shape, pinned, k, m, iterations, delta_t, gravity, damping }: MadeScene): string {
  const fields = {
    obj: `${name}.obj`,
    ...('picture' in shape && { png: `${name}.png` }),
    k,
    ...(m !== undefined && { m }),
    ...(iterations !== undefined && { iterations }),
    ...(delta_t !== undefined && { delta_t }),
    ...(gravity !== undefined && { gravity }),
    ...(damping !== undefined && { damping }),
    b: pinned.map((i) => i + 1),
  };
  return `${jsonText(fields)}\n`;
}

function objText({ name, vertices, shape }: MadeScene): string {
  const lines = [`# ${name}: made by scenes/generate.ts`];
  for (const point of vertices) lines.push(`v ${point.map(decimals).join(' ')}`);
  if ('springs' in shape) {
    for (const [i, j] of shape.springs) lines.push(`f ${i + 1} ${j + 1}`);
    for (const triangle of shape.triangles ?? []) lines.push(`f ${triangle.map((i) => i + 1).join(' ')}`);
  } else {
    for (const uv of shape.textureVertices) lines.push(`vt ${uv.map(decimals).join(' ')}`);
    for (const [f, triangle] of shape.triangles.entries()) {
      const corners = triangle.map((i, corner) => `${i + 1}/${shape.textureTriangles[f][corner] + 1}`);
      lines.push(`f ${corners.join(' ')}`);
    }
  }
  return `${lines.join('\n')}\n`;
}

/** Five decimals: 0.01 mm, coarse enough that the last digits of a machine's sines never show. */
function decimals(value: number): string {
  const rounded = Number(value.toFixed(5));
  return String(rounded === 0 ? 0 : rounded); // no −0
}
