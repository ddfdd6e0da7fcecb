import { expect, it } from 'vitest';
import {
  surrogate,
  withoutConstants,
} from '../../../../../../web/src/labs/lesson/sections/matrices/without_constants.ts';
import { smallMatrix } from '../../../../../../web/src/labs/lesson/sections/solving/small_matrix.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { SolverSession } from '../../../../../../web/src/solver/solver_session.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { solver } from '../../../../../support/open_simulation.ts';

const spring = await openScene('single-spring-horizontal');

it('without its constants Ẽ is lower by the same at every p, and lowest where Q p = b', () => {
  const parameters = { ...sceneParameters(spring), delta_t: 0.2, w: 100, path: 'plain' } as const;
  const request = {
    parameters,
    pins: { pinned: spring.pinned, targets: spring.V.slice(0, 3) },
    selectedVertex: 1,
    wholeTrace: true,
    profile: false,
  };
  const session = new SolverSession(solver, () => {});
  session.open(spring, { ...request, command: { kind: 'play', steps: 2 } }, null);
  for (let press = 0; press < 2; press++) session.run({ ...request, command: { kind: 'next_half_step' } });
  const outcome = session.run({ ...request, command: { kind: 'next_half_step' } });
  if (!outcome.ok) throw new Error(outcome.status.code);
  const { frame } = outcome.value;
  expect(frame.phase).toBe('global');

  const moves = [0, 1, -1, 0.3].map((by) => Float64Array.from(frame.p, (x, c) => x + by * Math.sin(c + 1)));
  const seen = session.inspect(moves);
  const Q = smallMatrix(seen.Q);
  const b = seen.equations.map((equation) => equation.b);
  const [i, j] = spring.E;
  const values = moves.map((p, at) => {
    const v = Float64Array.from([0, 1, 2], (axis) => p[3 * i + axis] - p[3 * j + axis]);
    const whole = surrogate(seen.evaluations[at], parameters.k, v, frame.d as Float64Array);
    return { whole, left: withoutConstants(Q, b, p) };
  });
  const [{ whole, left }] = values;
  for (const value of values) {
    expect(value.whole - value.left).toBeCloseTo(whole - left, 9); // rounding of some hundred joules
    expect(value.left).toBeGreaterThanOrEqual(left);
  }
});
