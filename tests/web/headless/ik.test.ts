import { spawnSync } from 'node:child_process';
import { describe, expect, it, test } from 'vitest';
import { parseIkArguments } from '../../../web/headless/parse_ik_arguments.ts';
import { UsageError } from '../../../web/headless/usage_error.ts';

function ik(...args: string[]) {
  const command = ['--import', 'tsx', 'web/headless/ik.ts', ...args];
  const { stdout, stderr, status } = spawnSync(process.execPath, command, { encoding: 'utf8' });
  return { stdout, stderr, status };
}

describe('ik', { timeout: 60_000 }, () => {
  it('prints one JSON object', () => {
    const args = ['--links', '0.8,0.4,0.2,1.2', '--root', '0,1.7,0', '--target', '0.6,0,0', '--method', 'fabrik'];
    const { stdout, stderr, status } = ik(...args);
    expect([stderr, status]).toEqual(['', 0]);
    const { joints, errors, ...answer } = JSON.parse(stdout);
    expect(answer).toEqual({ status: 'CONVERGED', iterations: errors.length, error: errors.at(-1) });
    expect(joints).toHaveLength(5);
    expect(joints[0]).toEqual([0, 1.7, 0]);
    expect(Math.hypot(joints[4][0] - 0.6, joints[4][1], joints[4][2])).toBeLessThanOrEqual(1e-4);
  });

  it('says in one line what the solver refuses, exit code 2', () => {
    const { stdout, stderr, status } = ik('--target', '0,1.7,0');
    expect([stdout, stderr, status]).toEqual(['', 'target: lies on the root, so that no direction leads to it\n', 2]);
  });
});

test('the lab’s chain hangs straight down unless told otherwise', () => {
  expect(parseIkArguments(['--target', '-1,0,2'])).toEqual({
    offsets: Float64Array.of(0, -0.8, 0, 0, -0.4, 0, 0, -0.2, 0, 0, -1.2, 0),
    root: Float64Array.of(0, 1.7, 0),
    start: new Float64Array(),
    start_q: new Float64Array(),
    target: Float64Array.of(-1, 0, 2),
    method: 'ccd',
    iterations: 100,
    epsilon: 1e-4,
    turn_limit: Math.PI,
    bend_limits: new Float64Array(),
    precision: 'double',
  });
});

test('takes all options', () => {
  const args = ['--links=1,2', '--root', '-1,0,0', '--start', '-1,0,0;0,0,0;0,2,0', '--target=1,1,1'];
  const others = ['--method', 'least-squares', '--iterations', '7', '--epsilon', '0.01', '--precision', 'single'];
  expect(parseIkArguments([...args, ...others])).toEqual({
    offsets: Float64Array.of(0, -1, 0, 0, -2, 0),
    root: Float64Array.of(-1, 0, 0),
    start: Float64Array.of(-1, 0, 0, 0, 0, 0, 0, 2, 0),
    start_q: new Float64Array(),
    target: Float64Array.of(1, 1, 1),
    method: 'least-squares',
    iterations: 7,
    epsilon: 0.01,
    turn_limit: Math.PI,
    bend_limits: new Float64Array(),
    precision: 'single',
  });
  expect(parseIkArguments(['--help'])).toBeNull();
});

test.each([
  [[], '--target: where to? X,Y,Z is needed'],
  [['--target', '1,2'], '--target: "1,2" is not three numbers X,Y,Z'],
  [['--target', '1,NaN,2'], '--target: "NaN" in "1,NaN,2" is not a number'],
  [['--target', '1,,2'], '--target: "" in "1,,2" is not a number'],
  [['--target', '1,1e200,2'], '--target: "1e200" in "1,1e200,2" is beyond ±1000000000 m'],
  [['--target', '0,0,0', '--iterations', '3e9'], '--iterations: "3e9" is more than 2147483647'],
  [['--target', '0,0,0', '--links', '1,two'], '--links: "two" in "1,two" is not a number'],
  [['--target', '0,0,0', '--start', '0,0,0;1,0,0'], '--start: 2 joints, but the links have 5'],
  [['--target', '0,0,0', '--method', 'jacobian'], '--method: "jacobian" is not one of ccd, fabrik, least-squares'],
  [['--target', '0,0,0', '--precision', 'half'], '--precision: "half" is not one of double, single'],
  [['--target', '0,0,0', '--iterations', '0'], '--iterations: "0" is not a whole number from 1 on'],
  [['--target', '0,0,0', '--epsilon', '-1'], '--epsilon: "-1" is not a positive number'],
  [['--target', '0,0,0', '--speed', '1'], '--speed: there is no such option'],
  [['--target'], '--target: its value is missing'],
  [['0,0,0'], '0,0,0: an option was expected'],
])('refuses %j', (args, sentence) => {
  expect(() => parseIkArguments(args)).toThrow(new UsageError(sentence));
});
