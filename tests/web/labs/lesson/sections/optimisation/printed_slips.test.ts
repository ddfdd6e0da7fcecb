import { expect, it } from 'vitest';
import { centralDifferences, pointsAround } from '../../../../../../web/src/labs/lesson/figures/finite_differences.ts';
import { free } from '../../../../../../web/src/labs/lesson/sections/optimisation/landscape_grid.ts';
import { printedSlips } from '../../../../../../web/src/labs/lesson/sections/optimisation/printed_slips.ts';
import { sceneParameters } from '../../../../../../web/src/solver/scene_parameters.ts';
import { openScene } from '../../../../../support/open_scene.ts';
import { distance, expectOk, openSimulation } from '../../../../../support/open_simulation.ts';

const spring = await openScene('single-spring-horizontal');
const parameters = { ...sceneParameters(spring), delta_t: 0.2 };

it.each(printedSlips)(
  'E with the slip $id has another gradient than the solver’s, the right E has the same',
  ({ printedEnergy }) => {
    const s = openSimulation(spring, parameters);
    for (let step = 0; step < 3; step++) expectOk(s.step());
    expectOk(s.next_step());
    expectOk(s.seek(2)); // after the first iteration: no term is in balance yet
    const p = s.p().slice();
    const known = { p_curr: s.p_curr().slice(), p_prev: s.p_prev().slice(), m: spring.m, ...parameters };
    const points = pointsAround(p, free);
    const evaluations = points.map((point) => ({ ...s.objective_at(point), gradient: new Float64Array() }));
    const gradient = s.gradient_at(p).slice(3 * free, 3 * free + 2);
    const pins = { pinned: spring.pinned, targets: new Float64Array(3) };

    const ofRight = centralDifferences(evaluations.map(({ objective }) => objective));
    const ofPrinted = centralDifferences(
      evaluations.map((evaluation, at) => printedEnergy({ ...evaluation, ...known, ...pins, p: points[at] })),
    );
    expect(distance(ofRight, gradient)).toBeLessThan(1e-5); // N: rounding of 10 J over 2·10⁻⁵ m, and h² of the third derivative
    expect(distance(ofPrinted, gradient)).toBeGreaterThan(1); // N: far more than differences could be wrong by
  },
);
