import { describe, expect, it } from 'vitest';
import { springFacts, vertexFacts } from '../../../web/src/app/thing_facts.ts';
import type { Frame } from '../../../web/src/solver/frame.ts';
import { figureOf } from '../../support/figure_of.ts';
import { chain } from '../../support/small_scenes.ts';

// Vertices at x = 0, 0.5 and 1 m, springs of 0.5 m and 1000 N/m between neighbours, the first vertex pinned.
const figureAt = (half_step: number) => figureOf(chain(3), { spring: null, vertex: 1 }, half_step);

describe('springFacts', () => {
  it('of a spring pulled from 0.5 m to 0.6 m: a fifth longer, and 100 N', () => {
    const figure = figureAt(1);
    (figure.frame.value as Frame).p[6] = 1.1; // x of the last vertex
    const facts = springFacts(figure, 1);
    expect(facts).toMatchObject({ i: 1, j: 2, r: 0.5, d: [-0.5, 0, 0] });
    // 1.1 − 0.5 is rounded once, at 2⁻⁵³ of about 1 m.
    expect(facts?.length).toBeCloseTo(0.6, 14);
    expect(facts?.strain).toBeCloseTo(0.2, 14);
    expect(facts?.pull).toBeCloseTo(100, 11);
  });

  it('of a squeezed one: it pushes', () => {
    const figure = figureAt(1);
    (figure.frame.value as Frame).p[6] = 0.75;
    expect(springFacts(figure, 1)?.pull).toBe(-250);
  });

  it('knows no projection at predict', () => {
    expect(springFacts(figureAt(0), 0)?.d).toBeNull();
  });
});

describe('vertexFacts', () => {
  it('counts springs, and knows where the pinned ones are held', () => {
    expect(vertexFacts(figureAt(1), 0)).toMatchObject({ mass: 1, springs: 1, target: [0, 0, 0], equation: null });
    expect(vertexFacts(figureAt(1), 1)).toMatchObject({ p: [0.5, 0, 0], pCurr: [0.5, 0, 0], springs: 2, target: null });
  });

  it('has the row of Qp = b of the selected vertex, once there is a d', () => {
    const equation = vertexFacts(figureAt(2), 1)?.equation;
    // After a global step Qp = b, to the rounding of Q's entries (w = 1e10 N/m) times p.
    for (const axis of [0, 1, 2]) expect(equation?.Qp[axis]).toBeCloseTo(equation?.b[axis] as number, 4);
    expect(vertexFacts(figureAt(0), 1)?.equation).toBeNull();
  });
});
