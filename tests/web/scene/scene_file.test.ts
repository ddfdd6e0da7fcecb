import { readFileSync } from 'node:fs';
import { Ajv2020 } from 'ajv/dist/2020.js';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { namesOneShape, sceneFileSchema } from '../../../web/src/scene/scene_file.ts';

const validate = new Ajv2020().compile(JSON.parse(readFileSync('scenes/scene.schema.json', 'utf8')));

function accepts(content: unknown): boolean {
  const result = sceneFileSchema.safeParse(content);
  return result.success && namesOneShape(result.data);
}

const number = fc.double({ noNaN: true, noDefaultInfinity: true });
const anything = fc.oneof(number, fc.constantFrom(0, 1, 1.5, 10_000, 10_001, null, '', 'a', true, [], [0], [1.5], {}));
const mostly = <T>(right: fc.Arbitrary<T>) =>
  fc.oneof({ weight: 9, arbitrary: right }, { weight: 1, arbitrary: anything });
const file = fc.record(
  {
    obj: mostly(fc.constant('a.obj')),
    mesh: mostly(fc.constant('a.mesh')),
    b: mostly(fc.array(fc.integer({ min: 1 }), { maxLength: 3 })),
    k: mostly(fc.constant(1e5)),
    m: anything,
    png: anything,
    delta_t: anything,
    iterations: anything,
    w: anything,
    gravity: anything,
    damping: anything,
    other: anything,
  },
  { requiredKeys: ['b', 'k'] },
);

describe('the schema of scene files', () => {
  it('accepts and refuses the same files as the JSON Schema beside the scenes', () => {
    const outcomes = new Set<boolean>();
    fc.assert(
      fc.property(file, (content) => {
        const accepted = accepts(content);
        expect(validate(content)).toBe(accepted);
        outcomes.add(accepted);
      }),
      { seed: 1, numRuns: 2000 },
    );
    expect(outcomes.size).toBe(2);
  });

  it.each(['obj', 'b', 'k'])('needs %s', (field) => {
    const content: Record<string, unknown> = { obj: 'a.obj', b: [1], k: 1 };
    delete content[field];
    expect([accepts(content), validate(content)]).toEqual([false, false]);
  });
});
