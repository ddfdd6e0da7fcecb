import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { meshDefaults } from '../../web/src/scene/mesh_defaults.ts';
import { parseMesh } from '../../web/src/scene/parse_mesh.ts';
import { describeSceneError, isSceneError } from '../../web/src/scene/scene_error.ts';
import { jsonText } from './json_text.ts';

/** The JSON of a rabbit, name → content: what a mesh gets that is opened alone. Its mesh comes from make_rabbit.py, which needs tools that are not ours. */
export function rabbitJson(name: string): [string, string] {
  const file = `${name}.mesh`;
  const mesh = parseMesh(file, readFileSync(join(import.meta.dirname, '..', file), 'utf8'));
  if (isSceneError(mesh)) throw new Error(describeSceneError(mesh));
  return [`${name}.json`, `${jsonText(meshDefaults(file, mesh.V))}\n`];
}
