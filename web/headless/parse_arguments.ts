import { parseArgs } from 'node:util';
import { type Method, methods } from '../src/solver/module.ts';
import { notNegative, oneOf, positive, wholeNumber } from './option_values.ts';
import { UsageError } from './usage_error.ts';

export interface Arguments {
  /** Path of the scene's JSON. */
  scene: string;
  steps: number;
  /** Each time step is made of so many, of as many parts of its length. */
  substeps: number;
  /** What replaces the scene's own values. Units as in the scene: s, N/m. */
  overrides: {
    iterations?: number;
    delta_t?: number;
    k?: number;
    damping?: number;
    method?: Method;
    stop_gradient?: number;
    stop_decrease?: number;
  };
  path: 'fast' | 'plain';
  storage: 'sparse' | 'dense';
  format: 'json' | 'csv';
}

export const help = `Runs a scene without a page and prints where its vertices end up.

  npm run --silent simulate -- SCENE.json [options]      (or SCENE.mesh, a Medit mesh that has no JSON)

  --steps N               time steps to run (100)
  --substeps N            made of so many shorter ones (1)
  --iterations K          the most iterations of each (the scene's)
  --method M              local-global|chebyshev|anderson|lbfgs|newton, which minimise E(p), iterate by iterate, or
                          linearly-implicit|symplectic-euler|forward-euler, which take the step at once (local-global)
  --until-gradient N      a step also ends where no vertex that is free feels more than N newtons of the gradient
  --until-decrease E      and once an iteration lowers the objective by no more than E max(1 J, the objective)
  --dt S                  time step in seconds (the scene's)
  --damping C             of a dashpot beside every spring in N s/m (the scene's)
  --k K                   stiffness of the springs in N/m (the scene's)
  --path fast|plain       how a step is computed (fast): fast holds pins exactly, plain by the penalty w
  --storage sparse|dense  of the matrices of the plain path (sparse); dense is always plain
  --format json|csv       (json) json is one object: positions in metres, velocities in metres a second, and
                          of each step the objective and the kinetic, spring and gravity energy in joules, how many
                          iterations were made and why no more, times in milliseconds; csv is a line vertex,x,y,z and
                          one for each vertex, numbered from 1 as in the file of the vertices, in metres
  --help                  this text

Errors: one line on stderr, exit code 2.
`;

const options = {
  steps: { type: 'string' },
  substeps: { type: 'string' },
  iterations: { type: 'string' },
  method: { type: 'string' },
  'until-gradient': { type: 'string' },
  'until-decrease': { type: 'string' },
  dt: { type: 'string' },
  damping: { type: 'string' },
  k: { type: 'string' },
  path: { type: 'string' },
  storage: { type: 'string' },
  format: { type: 'string' },
  help: { type: 'boolean' },
} as const;

/** Reads the command line; null asks for the help. */
export function parseArguments(args: string[]): Arguments | null {
  // Not strict, so that "--k -5" reaches the checks below and every complaint has the same form.
  const { values, positionals } = parseArgs({ args, options, strict: false });
  if (values.help) return null;
  for (const [name, value] of Object.entries(values)) {
    if (!(name in options)) throw new UsageError(`--${name}: there is no such option`);
    if (typeof value !== 'string') throw new UsageError(`--${name}: its value is missing`);
  }
  if (positionals.length !== 1) throw new UsageError(`SCENE.json: one file is needed, not ${positionals.length}`);
  const {
    steps = '100',
    substeps = '1',
    iterations,
    method,
    'until-gradient': untilGradient,
    'until-decrease': untilDecrease,
    dt,
    damping,
    k,
    storage = 'sparse',
    path = storage === 'dense' ? 'plain' : 'fast',
    format = 'json',
  } = values as Record<string, string | undefined>;
  return {
    scene: positionals[0],
    steps: wholeNumber('--steps', steps),
    substeps: wholeNumber('--substeps', substeps),
    overrides: {
      ...(iterations !== undefined && { iterations: wholeNumber('--iterations', iterations) }),
      ...(method !== undefined && { method: oneOf('--method', method, methods) }),
      ...(untilGradient !== undefined && { stop_gradient: positive('--until-gradient', untilGradient) }),
      ...(untilDecrease !== undefined && { stop_decrease: positive('--until-decrease', untilDecrease) }),
      ...(dt !== undefined && { delta_t: positive('--dt', dt) }),
      ...(damping !== undefined && { damping: notNegative('--damping', damping) }),
      ...(k !== undefined && { k: positive('--k', k) }),
    },
    path: pathFor(oneOf('--path', path, ['fast', 'plain']), storage),
    storage: oneOf('--storage', storage, ['sparse', 'dense']),
    format: oneOf('--format', format, ['json', 'csv']),
  };
}

function pathFor(path: 'fast' | 'plain', storage: string): 'fast' | 'plain' {
  if (path === 'fast' && storage === 'dense') throw new UsageError('--path: "fast" has no dense storage');
  return path;
}
