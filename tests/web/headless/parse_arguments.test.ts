import { describe, expect, it } from 'vitest';
import { parseArguments } from '../../../web/headless/parse_arguments.ts';
import { UsageError } from '../../../web/headless/usage_error.ts';

describe('parseArguments', () => {
  it('leaves to the scene what is not given', () => {
    expect(parseArguments(['a.json'])).toEqual({
      scene: 'a.json',
      steps: 100,
      substeps: 1,
      overrides: {},
      path: 'fast',
      storage: 'sparse',
      format: 'json',
    });
  });

  it('takes options before and after the file, with and without =', () => {
    const args = [
      '--steps',
      '3',
      '--k=2e5',
      'a.json',
      '--iterations',
      '7',
      '--dt',
      '0.01',
      '--storage=dense',
      '--format=csv',
      '--method=lbfgs',
      '--substeps',
      '4',
      '--damping=0',
      '--until-gradient=1e-3',
    ];
    expect(parseArguments(args)).toEqual({
      scene: 'a.json',
      steps: 3,
      substeps: 4,
      overrides: { k: 2e5, iterations: 7, delta_t: 0.01, damping: 0, method: 'lbfgs', stop_gradient: 1e-3 },
      path: 'plain',
      storage: 'dense',
      format: 'csv',
    });
  });

  it('asks for the help', () => {
    expect(parseArguments(['--help'])).toBeNull();
  });

  it.each([
    [[], 'SCENE.json: one file is needed, not 0'],
    [['a.json', 'b.json'], 'SCENE.json: one file is needed, not 2'],
    [['a.json', '--friction', '1'], '--friction: there is no such option'],
    [['a.json', '--damping', '-1'], '--damping: "-1" is not 0 or a positive number'],
    [['a.json', '--damping='], '--damping: "" is not 0 or a positive number'],
    [['a.json', '--substeps', '0'], '--substeps: "0" is not a whole number from 1 on'],
    [['a.json', '--k'], '--k: its value is missing'],
    [['a.json', '--k', '-5'], '--k: "-5" is not a positive number'],
    [['a.json', '--k', 'stiff'], '--k: "stiff" is not a positive number'],
    [['a.json', '--k', '1e999'], '--k: "1e999" is not a positive number'],
    [['a.json', '--dt', '0'], '--dt: "0" is not a positive number'],
    [['a.json', '--dt='], '--dt: "" is not a positive number'],
    [['a.json', '--steps', '1.5'], '--steps: "1.5" is not a whole number from 1 on'],
    [['a.json', '--iterations', '0'], '--iterations: "0" is not a whole number from 1 on'],
    [['a.json', '--storage', 'thick'], '--storage: "thick" is not one of sparse, dense'],
    [
      ['a.json', '--method', 'jacobi'],
      '--method: "jacobi" is not one of local-global, chebyshev, anderson, lbfgs, newton, linearly-implicit, symplectic-euler, forward-euler',
    ],
    [['a.json', '--until-decrease', '0'], '--until-decrease: "0" is not a positive number'],
    [['a.json', '--format', 'xml'], '--format: "xml" is not one of json, csv'],
  ])('refuses %j', (args, sentence) => {
    expect(() => parseArguments(args)).toThrow(new UsageError(sentence));
  });
});
