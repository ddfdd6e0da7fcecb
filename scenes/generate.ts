/** Makes every scene of this folder by rule, but for the meshes of the rabbits (see rules/make_rabbit.py): `npx tsx scenes/generate.ts [folder to write to]`. */
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { toJSONSchema } from 'zod/mini';
import { sceneFileSchema } from '../web/src/scene/scene_file.ts';
import { chain } from './rules/chain.ts';
import { cloth } from './rules/cloth.ts';
import { flag } from './rules/flag.ts';
import { jsonText } from './rules/json_text.ts';
import { net } from './rules/net.ts';
import { patch } from './rules/patch.ts';
import { rabbitJson } from './rules/rabbit.ts';
import { singleSpring } from './rules/single_spring.ts';
import { skirt } from './rules/skirt.ts';
import { square } from './rules/square.ts';
import { tower } from './rules/tower.ts';
import { triangle } from './rules/triangle.ts';
import { writtenScene } from './rules/written_scene.ts';

const folder = process.argv[2] ?? import.meta.dirname;

const scenes = [singleSpring(), triangle(), square(), chain(), patch(), net(), flag(), skirt(), tower(), cloth()];
const files = scenes.flatMap((scene) => [...writtenScene(scene)]);
files.push(rabbitJson('rabbit'), rabbitJson('rabbit-fine'));
const oneOf = ['obj', 'mesh'].map((field) => ({ required: [field] })); // namesOneShape
files.push(['scene.schema.json', `${jsonText({ ...toJSONSchema(sceneFileSchema, { io: 'input' }), oneOf })}\n`]);

for (const [name, content] of files) await writeFile(join(folder, name), content);
