import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { locateJsonError } from '../../../web/src/scene/locate_json_error.ts';

function isJson(text: string): boolean {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
}

describe('locateJsonError', () => {
  it.each([
    ['', 0],
    ['{"a": 1', 7],
    ['{"a": }', 6],
    ['{"a": 1,}', 8],
    ['[1, 2 3]', 6],
    ['[1,]', 3],
    ['{"a" 1}', 5],
    ['{a: 1}', 1],
    ['1 2', 2],
    ['[1}', 2],
    ['{"a": "b\n"}', 6],
    ['[01]', 2],
    ['[nul]', 1],
    ['[true', 5],
  ])('%j breaks at %i', (text, offset) => {
    expect(locateJsonError(text)).toBe(offset);
  });

  it('reads valid JSON to its end', () => {
    fc.assert(
      fc.property(fc.json(), (json) => {
        expect(locateJsonError(json)).toBe(json.length);
      }),
      { seed: 1 },
    );
  });

  it('leaves above the place it points at only what some ending makes JSON', () => {
    const damaged = fc
      .tuple(fc.json({ maxDepth: 3 }), fc.nat(), fc.constantFrom('', ',', '}', ']', ':', '"', 'x', '0', '\\', '\n'))
      .map(([json, place, patch]) => json.slice(0, place % json.length) + patch + json.slice((place % json.length) + 1))
      .filter((text) => !isJson(text));
    fc.assert(
      fc.property(damaged, (text) => {
        const head = text.slice(0, locateJsonError(text));
        const endings = ['', '0', ':0', '"":0'].map((ending) => ending + closingBrackets(head));
        expect(endings.some((ending) => isJson(head + ending))).toBe(true);
      }),
      { seed: 2 },
    );
  });
});

/** The brackets that close those open at the end of `head`. */
function closingBrackets(head: string): string {
  let closing = '';
  for (const bracket of head.replace(/"(?:[^"\\]|\\.)*"/g, '').replace(/[^[\]{}]/g, '')) {
    closing = '[{'.includes(bracket) ? (bracket === '[' ? ']' : '}') + closing : closing.slice(1);
  }
  return closing;
}
