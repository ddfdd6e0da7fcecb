import type { en } from '../en/index.ts';
import type { Catalogue } from '../index.ts';
import { code } from './code.ts';
import { equations } from './equations.ts';
import { matrices } from './matrices.ts';
import { methods } from './methods.ts';
import { page } from './page.ts';
import { plots } from './plots.ts';
import { scene } from './scene.ts';
import { symbols } from './symbols.ts';

export const zh: Catalogue<typeof en> = { page, symbols, equations, code, matrices, methods, plots, scene };
