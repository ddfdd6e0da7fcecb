import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Geometry } from '../../../web/src/scene/geometry.ts';
import { parseObj } from '../../../web/src/scene/parse_obj.ts';
import { describeSceneError, isSceneError } from '../../../web/src/scene/scene_error.ts';

const coordinate = fc.double({ noNaN: true, noDefaultInfinity: true }).map((x) => x || 0); // −0 is written as 0
const square = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';

function parsed(text: string): Geometry {
  const result = parseObj('a.obj', text);
  if (isSceneError(result)) throw new Error(describeSceneError(result));
  return result;
}

describe('parseObj', () => {
  it('reads back every network that can be written', () => {
    const network = fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 2, maxLength: 20 }).chain((V) =>
      fc.record({
        V: fc.constant(V),
        E: fc.uniqueArray(
          fc.tuple(fc.nat(V.length - 1), fc.nat(V.length - 1)).filter(([i, j]) => i !== j),
          { minLength: 1, selector: ([i, j]) => `${Math.min(i, j)} ${Math.max(i, j)}` },
        ),
      }),
    );
    fc.assert(
      fc.property(network, ({ V, E }) => {
        const lines = [...V.map((point) => `v ${point.join(' ')}`), ...E.map(([i, j]) => `f ${i + 1} ${j + 1}`)];
        const obj = parsed(lines.join('\n'));
        expect([...obj.V]).toEqual(V.flat());
        expect([...obj.E]).toEqual(E.flat());
        expect(obj.F).toHaveLength(0);
      }),
      { seed: 1 },
    );
  });

  it('takes each edge of a polygon once as a spring, and fans its triangles', () => {
    const { E, F, FT } = parsed(`${square}v 2 0 0\nf 1 2 3 4\nf 2 5 3`);
    expect([...E]).toEqual([0, 1, 1, 2, 2, 3, 3, 0, 1, 4, 4, 2]);
    expect([...F]).toEqual([0, 1, 2, 0, 2, 3, 1, 4, 2]);
    expect(FT).toBeNull();
  });

  it('reads springs, polylines and polygons in one file, a spring given twice as one', () => {
    const { E, F } = parsed(`${square}f 3 1\nl 1 2 3\nf 1 3\nf 3 2 1`);
    expect([...E]).toEqual([2, 0, 0, 1, 1, 2]);
    expect([...F]).toEqual([2, 1, 0]);
  });

  it.each(['1', '1/2', '1//1', '1/2/1'])('reads a corner written %s', (corner) => {
    const { E, FT } = parsed(`${square}vt 0 0\nvt 1 1\nvn 0 0 1\nf ${corner} 2/1 3/1`);
    expect([...E]).toEqual([0, 1, 1, 2, 2, 0]);
    expect(FT && [...FT]).toEqual(corner.startsWith('1/2') ? [1, 0, 0] : null);
  });

  it('counts negative indices back from the line they stand on', () => {
    const { E } = parsed('v 0 0 0\nv 1 0 0\nf -1 -2\nv 2 0 0\nf -1 -2');
    expect([...E]).toEqual([1, 0, 2, 1]);
  });

  it('keeps the digits of a coordinate', () => {
    expect(parsed('v 1.0103629710818454 -0 +2.5e-3\nv 0 0 0\nf 1 2').V.slice(0, 3)).toEqual(
      Float64Array.of(1.0103629710818454, -0, 0.0025),
    );
  });

  it('ignores comments, blank lines, carriage returns, indentation, weights and what scenes do not use', () => {
    const { V, E } = parsed('# a net\r\no net\r\n\r\n  v 0 0 0 1.0 # first\r\nv\t1 0 0\r\ns off\r\nf 1 2\r\n');
    expect([V.length, E.length]).toEqual([6, 2]);
  });

  it.each([
    ['v 0 0', 'a.obj line 1: has 2 numbers of 3'],
    [`${square}vt 1`, 'a.obj line 5: has 1 numbers of 2'],
    ['v 0 x 0', 'a.obj line 1: x is not a finite number'],
    ['v 0 0 1e999', 'a.obj line 1: 1e999 is not a finite number'],
    [`${square}f 1`, 'a.obj line 5: joins fewer than 2 vertices'],
    [`${square}f 1 5`, 'a.obj line 5: vertex 5 of 4'],
    [`${square}f 1 -5`, 'a.obj line 5: vertex -5 of 4'],
    [`${square}f 1 0`, 'a.obj line 5: 0 is not a vertex number'],
    [`${square}\nf 1 2.5`, 'a.obj line 6: 2.5 is not a vertex number'],
    [`${square}f 1/x 2 3`, 'a.obj line 5: 1/x is not a vertex number'],
    [`${square}vt 0 0\nf 1/1 2/2 3/1`, 'a.obj line 6: texture vertex 2 of 1'],
    [`${square}f 2 2`, 'a.obj line 5: vertex 2 is joined to itself'],
    [`${square}f 1 2 3 1`, 'a.obj line 5: vertex 1 is joined to itself'],
    ['# empty', 'a.obj: there are no vertices'],
    [square, 'a.obj: there are no springs'],
    ['v 0 0 0\n'.repeat(100_001), 'a.obj: 100001 vertices are more than 100000'],
  ])('refuses %.40j', (text, sentence) => {
    const result = parseObj('a.obj', text);
    expect(isSceneError(result) && describeSceneError(result)).toBe(sentence);
  });

  it('refuses more springs than it may keep', () => {
    const count = 1009; // prime: a closed walk of any stride passes every vertex; 504 strides join every two, 508,536 springs
    const walk = (stride: number) => Array.from({ length: count + 1 }, (_, i) => ((i * stride) % count) + 1);
    const walks = Array.from({ length: (count - 1) / 2 }, (_, i) => `l ${walk(i + 1).join(' ')}\n`);
    const text = 'v 0 0 0\n'.repeat(count) + walks.join('');
    expect(parseObj('a.obj', text)).toMatchObject({ code: 'too_many_springs', params: { maximum: 500_000 } });
  });
});
