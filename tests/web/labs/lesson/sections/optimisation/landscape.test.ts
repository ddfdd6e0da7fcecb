import { expect, it } from 'vitest';
import {
  cornerAt,
  free,
  landscape,
  landscapePoints,
} from '../../../../../../web/src/labs/lesson/sections/optimisation/landscape_grid.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { SolverSession } from '../../../../../../web/src/solver/solver_session.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { distance, solver } from '../../../../../support/open_simulation.ts';

const spring = await openScene('single-spring-horizontal');
const request = {
  parameters: { ...sceneParameters(spring), delta_t: 0.2 },
  pins: { pinned: spring.pinned, targets: spring.V.slice(0, 3) },
  selectedVertex: free,
  wholeTrace: true,
  profile: false,
};
const session = new SolverSession(solver, () => {});

function frameAfter(command: Parameters<SolverSession['run']>[0]['command']) {
  const outcome = session.run({ ...request, command });
  if (!outcome.ok) throw new Error(outcome.status.code);
  return outcome.value.frame;
}

it('the iterates are those that half-steps show, they end in the lowest part of the map, and nothing has moved', () => {
  session.open(spring, { ...request, command: { kind: 'play', steps: 1 } }, null);
  const start = frameAfter({ kind: 'next_half_step' });
  const seen = session.inspect(landscapePoints(start));
  expect(frameAfter({ kind: 'stay' })).toEqual({ ...start, milliseconds: expect.any(Number) });

  expect(seen.iterates).toHaveLength(1 + request.parameters.iterations);
  expect(seen.iterates[0]).toEqual(start.p);
  expect(seen.iterates[2]).toEqual(frameAfter({ kind: 'seek', half_step: 4 }).p);

  const { columns, values } = landscape('sum', seen.evaluations);
  const lowest = values.indexOf(values.reduce((a, b) => Math.min(a, b)));
  const corner = cornerAt([lowest % columns, Math.floor(lowest / columns)]);
  const end = seen.iterates[request.parameters.iterations].subarray(3 * free, 3 * free + 3);
  expect(distance(end, corner)).toBeLessThan(0.05); // m: no farther than the next corner of the grid
});
