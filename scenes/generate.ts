/** Makes every scene of this folder by rule: `npx tsx scenes/generate.ts [folder to write to]`. */
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { toJSONSchema } from 'zod/mini';
import { sceneFileSchema } from '../web/src/scene/scene_file.ts';
import { chain } from './rules/chain.ts';
import { flag } from './rules/flag.ts';
import { jsonText } from './rules/json_text.ts';
import { net } from './rules/net.ts';
import { patch } from './rules/patch.ts';
import { singleSpring } from './rules/single_spring.ts';
import { skirt } from './rules/skirt.ts';
import { square } from './rules/square.ts';
import { tower } from './rules/tower.ts';
import { triangle } from './rules/triangle.ts';
import { writtenScene } from './rules/written_scene.ts';

const folder = process.argv[2] ?? import.meta.dirname;

const scenes = [singleSpring(), triangle(), square(), chain(), patch(), net(), flag(), skirt(), tower()];
const files = scenes.flatMap((scene) => [...writtenScene(scene)]);
files.push(['scene.schema.json', `${jsonText(toJSONSchema(sceneFileSchema, { io: 'input' }))}\n`]);

for (const [name, content] of files) await writeFile(join(folder, name), content);
