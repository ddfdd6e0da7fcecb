import { sceneMessages } from '../../../scene/scene_error.ts';
import { code } from './code.ts';
import { equations } from './equations.ts';
import { matrices } from './matrices.ts';
import { methods } from './methods.ts';
import { page } from './page.ts';
import { plots } from './plots.ts';
import { symbols } from './symbols.ts';

export const en = { page, symbols, equations, code, matrices, methods, plots, scene: sceneMessages };
