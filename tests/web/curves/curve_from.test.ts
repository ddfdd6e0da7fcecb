import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { curveFrom } from '../../../web/src/curves/curve_from.ts';
import { glyphs } from '../../../web/src/curves/glyphs.ts';
import { curveOf, problemOf, someChoices } from './some_curves.ts';

/** Points of all strokes, close to one another. */
function pointsOf(choice: Parameters<typeof curveOf>[0]) {
  return curveOf(choice).strokes.flatMap(({ from, to, at }) =>
    Array.from({ length: 301 }, (_, k) => at(from + ((to - from) * k) / 300)),
  );
}

describe('curveFrom', () => {
  it('makes strokes that are finite everywhere, with corners inside and the ends together where they are closed', () => {
    for (const choice of someChoices)
      for (const { from, to, at, corners, closed } of curveOf(choice).strokes) {
        expect(from).toBeLessThan(to);
        for (const corner of corners) expect(corner > from && corner < to).toBe(true);
        const [start, end] = [at(from), at(to)];
        expect(Math.hypot(end[0] - start[0], end[1] - start[1]) < 1e-9).toBe(closed); // rounding of sin 2π and the like
      }
  });

  it('never throws', () => {
    const text = fc.string({ unit: 'grapheme', maxLength: 40 });
    fc.assert(
      fc.property(
        fc.oneof(
          fc.record({ kind: fc.constant('letters' as const), text }),
          fc.record({ kind: fc.constant('path' as const), d: text }),
          fc.record({
            kind: fc.constant('path' as const),
            d: fc.string({ unit: fc.constantFrom(...'MmLlHhVvCcSsQqTtAaZzRr0123. ,-e<"') }),
          }),
          fc.record({ kind: fc.constant('formula' as const), x: text, y: text, from: text, to: text }),
          fc.record({
            kind: fc.constant('hand' as const),
            strokes: fc.array(fc.array(fc.tuple(fc.double(), fc.double()), { maxLength: 5 }), { maxLength: 3 }),
          }),
        ),
        (choice) => {
          const result = curveFrom(choice);
          if (result.ok)
            for (const { from, to, at } of result.curve.strokes)
              for (const t of [from, (from + to) / 2, to]) expect(at(t).every(Number.isFinite)).toBe(true);
          else expect(result.problem.column).toBeGreaterThanOrEqual(1);
        },
      ),
      { numRuns: 1000 },
    );
  });
});

describe('letters', () => {
  // The box is 1.6 m by 0.6 m; arcs are measured at steps.
  const halfWidth = 0.8 + 1e-4;
  const halfHeight = 0.3 + 1e-4;

  it.each([...Object.keys(glyphs)].filter((character) => character !== ' '))(
    'has a drawable “%s” inside the box',
    (character) => {
      const points = pointsOf({ kind: 'letters', text: character });
      expect(points.length).toBeGreaterThan(0);
      for (const [x, y] of points) {
        expect(Math.abs(x)).toBeLessThan(halfWidth);
        expect(Math.abs(y)).toBeLessThan(halfHeight);
      }
    },
  );

  it('has all letters, digits and the punctuation of a short message', () => {
    for (const character of "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 .,!?-+='")
      expect(glyphs).toHaveProperty([character]);
  });

  it('fills the width of the box with a long text, and the height with a capital', () => {
    const xs = pointsOf({ kind: 'letters', text: 'Mass and spring' }).map(([x]) => x);
    expect(Math.max(...xs) - Math.min(...xs)).toBeCloseTo(1.6, 3);
    const ys = pointsOf({ kind: 'letters', text: 'I' }).map(([, y]) => y);
    expect(Math.max(...ys) - Math.min(...ys)).toBeCloseTo(0.6, 3);
  });

  it('goes from left to right, one stroke after the other, upright', () => {
    const [stem, arm] = curveOf({ kind: 'letters', text: 'T' }).strokes; // drawn: bar, then stem
    expect(stem?.at(0)[0]).toBeLessThan(0);
    expect(arm?.at(0)[1]).toBeCloseTo(0.3, 12);
    expect(arm?.at(1)[1]).toBeCloseTo(-0.3, 12);
  });

  it('reads the full-width forms of Chinese input methods', () => {
    expect(pointsOf({ kind: 'letters', text: 'Ｏｋ！' })).toEqual(pointsOf({ kind: 'letters', text: 'Ok!' }));
  });

  it.each([
    ['', 1, { code: 'empty' }],
    ['  ', 1, { code: 'empty' }],
    ['ab€', 3, { code: 'no_such_letter', character: '€' }],
    ['🙂', 1, { code: 'no_such_letter', character: '🙂' }],
    ['你好', 1, { code: 'no_such_letter', character: '你' }],
    ['constructor$', 12, { code: 'no_such_letter', character: '$' }],
    ['a'.repeat(25), 25, { code: 'too_long', maximum: 24 }],
  ])('refuses “%s”', (text, column, reason) =>
    expect(problemOf({ kind: 'letters', text })).toEqual({ field: 'text', column, ...reason }),
  );
});

describe('formula', () => {
  const formula = (change: object) => ({
    kind: 'formula' as const,
    x: 'cos(t)',
    y: 'sin(t)',
    from: '0',
    to: '2 pi',
    ...change,
  });

  it('is the curve in metres as it stands', () => {
    const [stroke] = curveOf(formula({ x: '3 cos(t)' })).strokes;
    expect(stroke?.to).toBe(2 * Math.PI);
    expect(stroke?.at(1)).toEqual([3 * Math.cos(1), Math.sin(1)]);
    expect(stroke?.closed).toBe(true);
    expect(curveOf(formula({ to: 'pi' })).strokes[0]?.closed).toBe(false);
  });

  it.each([
    [{ x: '' }, 'x', 1, { code: 'empty' }],
    [{ y: '1 + sn(t)' }, 'y', 5, { code: 'unknown_name', name: 'sn' }],
    [{ from: '1 + t' }, 'from', 5, { code: 'contains_t' }],
    [{ to: '6 + πt' }, 'to', 6, { code: 'contains_t' }],
    [{ to: '6 + tπ' }, 'to', 5, { code: 'contains_t' }],
    [{ to: '1/0' }, 'to', 1, { code: 'bound_not_finite' }],
    [{ to: '0' }, 'to', 1, { code: 'empty_range', from: 0, to: 0 }],
    [{ from: '3', to: '2' }, 'to', 1, { code: 'empty_range', from: 3, to: 2 }],
    [{ y: 'sqrt(1 - t)', to: '2' }, 'y', 1, { code: 'not_finite', t: 1.001 }],
    [{ x: '1/(t - 1)', to: '2' }, 'x', 1, { code: 'too_far', t: 0.991, value: 1 / (0.991 - 1), maximum: 100 }],
    [{ x: '1', y: '2' }, 'x', 1, { code: 'no_length' }],
  ])('refuses %o', (change, field, column, reason) =>
    expect(problemOf(formula(change))).toEqual({ field, column, ...reason }),
  );

  it('bridges a hole narrower than the steps that it looks at', () => {
    // A root of a negative number for 0.50011 < t < 0.50012.
    const [stroke] = curveOf(formula({ y: 'sqrt((t - 0.50011)(t - 0.50012))', to: '2' })).strokes;
    expect(stroke?.at(0.500115)).toEqual(stroke?.at(0.5));
  });
});

describe('hand', () => {
  it('goes through the points, and leaves out what trembles', () => {
    const [stroke] = curveOf({
      kind: 'hand',
      strokes: [
        [
          [0, 0],
          [0.001, 0.001],
          [1, 0],
          [1, 1],
        ],
      ],
    }).strokes;
    expect([0, 1, 2].map((t) => stroke?.at(t))).toEqual([
      [0, 0],
      [1, 0],
      [1, 1],
    ]);
    expect(stroke?.corners).toEqual([]);
  });

  it.each([
    [[], 1, { code: 'empty' }],
    [[[]], 1, { code: 'no_length' }],
    [[[[1, 1] as const, [1, 1] as const]], 1, { code: 'no_length' }],
    [[[[1, 1] as const], [[1, Number.NaN] as const]], 2, { code: 'point_too_far', maximum: 100 }],
  ])('refuses %j', (strokes, column, reason) =>
    expect(problemOf({ kind: 'hand', strokes })).toEqual({ field: 'strokes', column, ...reason }),
  );
});

describe('path', () => {
  it('stands upright in the box, whatever its size', () => {
    const [stroke] = curveOf({ kind: 'path', d: 'M0 0 L0 300 H100' }).strokes; // down, then right
    const corners = [0, 1, 2].map((t) => stroke?.at(t));
    // 300 units are 0.6 m.
    expect(corners).toEqual([
      [expect.closeTo(-0.1, 12), expect.closeTo(0.3, 12)],
      [expect.closeTo(-0.1, 12), expect.closeTo(-0.3, 12)],
      [expect.closeTo(0.1, 12), expect.closeTo(-0.3, 12)],
    ]);
    expect(stroke?.corners).toEqual([1]);
  });

  it('knows all commands, relative ones too', () => {
    const absolute = 'M10 10L20 10H30V20C30 30 40 30 40 20S50 10 50 20Q60 30 70 20T90 20A10 10 0 0 1 110 20Z';
    const relative = 'm10 10l10 0h10v10c0 10 10 10 10 0s10-10 10 0q10 10 20 0t20 0a10 10 0 0 1 20 0z';
    expect(pointsOf({ kind: 'path', d: relative })).toEqual(
      pointsOf({ kind: 'path', d: absolute }).map((point) => point.map((x) => expect.closeTo(x, 12))),
    );
    expect(curveOf({ kind: 'path', d: absolute }).strokes[0]?.to).toBe(10); // half a turn of an arc is two cubics, and the line home
  });

  it('draws an arc as a circle, but for the cubics in its place', () => {
    const [stroke] = curveOf({ kind: 'path', d: 'M0 1A1 1 0 0 1 2 1A1 1 0 0 1 0 1Z' }).strokes;
    expect(stroke).toMatchObject({ closed: true, corners: [] });
    for (let t = 0; t <= 4; t += 0.05) expect(Math.hypot(...(stroke?.at(t) ?? []))).toBeCloseTo(0.3, 3); // a cubic's quarter is off by 2.7e-4 of r
  });

  it('makes a stroke of every subpath, and goes on from the start of a closed one', () => {
    const { strokes } = curveOf({ kind: 'path', d: 'M0 0H1V1ZL-1 0M5 5M2 2L3 3' });
    expect(strokes.map(({ closed, to }) => [closed, to])).toEqual([
      [true, 3],
      [false, 1],
      [false, 1],
    ]);
  });

  it('finds the paths in pasted markup', () => {
    const markup = `<svg viewBox="0 0 9 9"><path id="a" d="M0 0H9"/><path\n class='x' d='M0 0V9'></path></svg>`;
    expect(curveOf({ kind: 'path', d: markup }).strokes).toHaveLength(2);
    expect(problemOf({ kind: 'path', d: '<path d="M0 0 X"/>' })).toEqual({
      field: 'd',
      column: 15,
      code: 'not_path_data',
      found: 'X',
    });
    expect(problemOf({ kind: 'path', d: '<svg></svg>' })).toMatchObject({ code: 'no_path_in_markup' });
  });

  it.each([
    ['', 1, { code: 'empty' }],
    ['L1 1', 1, { code: 'no_move_first', found: 'L' }],
    ['  hello', 3, { code: 'no_move_first', found: 'h' }],
    ['M0 0 L1', 8, { code: 'path_ends_early' }],
    ['M0 0 L1 x', 9, { code: 'not_path_data', found: 'x' }],
    ['M0 0 B1 1', 6, { code: 'not_path_data', found: 'B' }],
    ['M0 0 R1 1 2 2', 6, { code: 'not_path_data', found: 'R' }],
    ['M0 0 A1 1 0 2 0 3 3', 13, { code: 'not_path_data', found: '2' }],
    ['M0 0 L1e999 0', 7, { code: 'too_large', found: '1e999', maximum: 1e9 }],
    ['M0 0h1'.repeat(501), 1, { code: 'too_many_corners', count: 1002, maximum: 1000 }],
    ['M5 5', 1, { code: 'no_length' }],
    ['M5 5L5 5Z', 1, { code: 'no_length' }],
    [`M0 0${'L1 1'.repeat(5000)}`, 20_001, { code: 'too_long', maximum: 20_000 }],
  ])('refuses %s', (d, column, reason) =>
    expect(problemOf({ kind: 'path', d })).toEqual({ field: 'd', column, ...reason }),
  );
});
