import { parseArgs } from 'node:util';
import { type IkTask, ikMethods } from '../src/solver/inverse_kinematics.ts';
import { oneOf, positive, wholeNumber } from './option_values.ts';
import { UsageError } from './usage_error.ts';

export const ikHelp = `Turns the joints of a chain until its end is where you want it, without a page.

  npm run --silent ik -- --target X,Y,Z [options]

  --target X,Y,Z              where the end effector is to go, m
  --links L1,L2,…             lengths of the links, m (0.8,0.4,0.2,1.2)
  --root X,Y,Z                where the first joint stands, m (0,1.7,0)
  --start X,Y,Z;X,Y,Z;…       where all joints are at first, m; only the directions count (straight down from the root)
  --method M                  ccd|fabrik|least-squares (ccd)
  --iterations N              the most (100)
  --epsilon E                 how near is near enough, m (1e-4)
  --precision double|single   single as graphics libraries compute the rotation between two vectors (double)
  --help                      this text

Prints one JSON object: status (CONVERGED, STALLED, UNREACHABLE or MAX_ITERATIONS), iterations, error in metres, joints
in metres, and the error after each iteration. Errors: one line on stderr, exit code 2.
`;

const options = {
  target: { type: 'string' },
  links: { type: 'string' },
  root: { type: 'string' },
  start: { type: 'string' },
  method: { type: 'string' },
  iterations: { type: 'string' },
  epsilon: { type: 'string' },
  precision: { type: 'string' },
  help: { type: 'boolean' },
} as const;

/** Reads the command line; null asks for the help. */
export function parseIkArguments(args: string[]): IkTask | null {
  // Not strict, so that "--target -1,0,0" reaches the checks below and every complaint has the same form.
  const { values, positionals } = parseArgs({ args: joinedValues(args), options, strict: false });
  if (values.help) return null;
  for (const [name, value] of Object.entries(values)) {
    if (!(name in options)) throw new UsageError(`--${name}: there is no such option`);
    if (typeof value !== 'string') throw new UsageError(`--${name}: its value is missing`);
  }
  if (positionals.length > 0) throw new UsageError(`${positionals[0]}: an option was expected`);
  const {
    target,
    links = '0.8,0.4,0.2,1.2',
    root = '0,1.7,0',
    start,
    method = 'ccd',
    iterations = '100',
    epsilon = '1e-4',
    precision = 'double',
  } = values as Record<string, string | undefined>;
  if (target === undefined) throw new UsageError('--target: where to? X,Y,Z is needed');
  const lengths = numbers('--links', links);
  return {
    offsets: Float64Array.from(lengths.flatMap((length) => [0, -length, 0])),
    root: point('--root', root),
    start: Float64Array.from(start === undefined ? [] : joints(start, lengths.length + 1)),
    start_q: new Float64Array(),
    target: point('--target', target),
    method: oneOf('--method', method, ikMethods),
    iterations: wholeNumber('--iterations', iterations),
    epsilon: positive('--epsilon', epsilon),
    turn_limit: Math.PI,
    bend_limits: new Float64Array(),
    precision: oneOf('--precision', precision, ['double', 'single']),
  };
}

/** "--root -1,0,0" as "--root=-1,0,0": a value may begin with a minus. */
function joinedValues(args: string[]): string[] {
  const joined: string[] = [];
  for (const arg of args) {
    const before = joined.at(-1);
    if (/^-[\d.]/.test(arg) && before?.startsWith('--') && !before.includes('='))
      joined[joined.length - 1] = `${before}=${arg}`;
    else joined.push(arg);
  }
  return joined;
}

function joints(text: string, count: number): number[] {
  const points = text.split(';');
  if (points.length !== count) throw new UsageError(`--start: ${points.length} joints, but the links have ${count}`);
  return points.flatMap((one) => [...point('--start', one)]);
}

function point(option: string, text: string): Float64Array {
  const coordinates = numbers(option, text);
  if (coordinates.length !== 3) throw new UsageError(`${option}: "${text}" is not three numbers X,Y,Z`);
  return Float64Array.from(coordinates);
}

/** m: the squares of more would leave single precision. */
const largest = 1e9;

function numbers(option: string, text: string): number[] {
  return text.split(',').map((part) => {
    const value = part.trim() === '' ? Number.NaN : Number(part);
    if (!Number.isFinite(value)) throw new UsageError(`${option}: "${part}" in "${text}" is not a number`);
    if (Math.abs(value) > largest) throw new UsageError(`${option}: "${part}" in "${text}" is beyond ±${largest} m`);
    return value;
  });
}
