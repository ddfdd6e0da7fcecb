import { describe, expect, it } from 'vitest';
import { parseSceneFile } from '../../../web/src/scene/parse_scene_file.ts';
import { describeSceneError, isSceneError } from '../../../web/src/scene/scene_error.ts';

function sentence(text: string): string {
  const result = parseSceneFile('a.json', text);
  return isSceneError(result) ? describeSceneError(result) : '';
}

describe('parseSceneFile', () => {
  it('fills in the defaults', () => {
    expect(parseSceneFile('a.json', '{"obj": "a.obj", "b": [1, 3], "k": 3e2}')).toEqual({
      obj: 'a.obj',
      b: [1, 3],
      k: 300,
      delta_t: 1 / 30,
      iterations: 50,
      w: 1e10,
      gravity: 9.8,
      damping: 0,
    });
  });

  it('keeps what is given and drops the fields of other programs', () => {
    const fields = { obj: 'a.obj', b: [], k: 1, m: 2, png: 'a.png', delta_t: 0.01, iterations: 10, w: 1e6 };
    Object.assign(fields, { gravity: 0, damping: 0.2 });
    expect(parseSceneFile('a.json', JSON.stringify({ ...fields, author: 'x' }))).toEqual(fields);
  });

  it.each([
    ['', 'a.json line 1: column 1: the JSON ends too early'],
    ['{\n  "obj": "a.obj",\n}', 'a.json line 3: column 1: not JSON from } on'],
    ['{"b": [1 2]}', 'a.json line 1: column 10: not JSON from 2]} on'],
    ['[]', 'a.json: [] is not an object in braces'],
    ['null', 'a.json: null is not an object in braces'],
    ['{"b": [], "k": 1}', 'a.json: either "obj" or "mesh" is needed: the file of the vertices'],
    [
      '{"obj": "a", "mesh": "b", "b": [], "k": 1}',
      'a.json: "obj" and "mesh" are both given: only one can be the file of the vertices',
    ],
    ['{"mesh": "", "b": [], "k": 1}', 'a.json mesh: this text is empty'],
    ['{"mesh": "a", "b": [], "k": 1, "gravity": -1}', 'a.json gravity: -1 is less than 0'],
    ['{"mesh": "a", "b": [], "k": 1, "damping": -0.1}', 'a.json damping: -0.1 is less than 0'],
    ['{"obj": "", "b": [], "k": 1}', 'a.json obj: this text is empty'],
    ['{"obj": 7, "b": [], "k": 1}', 'a.json obj: 7 is not a text in quotes'],
    ['{"obj": "a", "k": 1}', 'a.json b: this field is missing'],
    ['{"obj": "a", "b": 1, "k": 1}', 'a.json b: 1 is not a list'],
    ['{"obj": "a", "b": [1, 0], "k": 1}', 'a.json b[1]: 0 is less than 1'],
    ['{"obj": "a", "b": [1.5], "k": 1}', 'a.json b[0]: 1.5 is not a whole number'],
    ['{"obj": "a", "b": [null], "k": 1}', 'a.json b[0]: null is not a finite number'],
    ['{"obj": "a", "b": []}', 'a.json k: this field is missing'],
    ['{"obj": "a", "b": [], "k": "1e5"}', 'a.json k: "1e5" is not a finite number'],
    ['{"obj": "a", "b": [], "k": 1e999}', 'a.json k: Infinity is not a finite number'],
    ['{"obj": "a", "b": [], "k": 0}', 'a.json k: 0 is not positive'],
    ['{"obj": "a", "b": [], "k": 1, "m": -1}', 'a.json m: -1 is not positive'],
    ['{"obj": "a", "b": [], "k": 1, "delta_t": null}', 'a.json delta_t: null is not a finite number'],
    ['{"obj": "a", "b": [], "k": 1, "w": 0}', 'a.json w: 0 is not positive'],
    ['{"obj": "a", "b": [], "k": 1, "iterations": 0}', 'a.json iterations: 0 is less than 1'],
    ['{"obj": "a", "b": [], "k": 1, "iterations": 1e5}', 'a.json iterations: 100000 is more than 10000'],
    [
      '{"obj": "a", "b": [], "k": {"everywhere": "as stiff as steel"}}',
      'a.json k: {"everywhere":"as stiff as ste… is not a finite number',
    ],
  ])('refuses %j', (text, expected) => {
    expect(sentence(text)).toBe(expected);
  });
});
