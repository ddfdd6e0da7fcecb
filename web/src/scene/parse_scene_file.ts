import type { core } from 'zod/mini';
import { locateJsonError } from './locate_json_error.ts';
import type { SceneError, SceneErrorCode } from './scene_error.ts';
import { namesOneShape, type SceneFile, sceneFileSchema } from './scene_file.ts';

/** Reads the JSON of a scene. `file` is its name, for the sentences of errors. */
export function parseSceneFile(file: string, text: string): SceneFile | SceneError {
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch {
    return syntaxError(file, text);
  }
  const result = sceneFileSchema.safeParse(json);
  if (!result.success) return fieldError(file, json, result.error.issues[0]);
  if (namesOneShape(result.data)) return result.data;
  return { code: result.data.obj === undefined ? 'no_shape' : 'two_shapes', place: { file }, params: {} };
}

function syntaxError(file: string, text: string): SceneError {
  const offset = locateJsonError(text);
  const lines = text.slice(0, offset).split('\n');
  const place = { file, line: lines.length };
  const column = lines[lines.length - 1].length + 1;
  if (offset === text.length) return { code: 'json_ends_early', place, params: { column } };
  return { code: 'not_json', place, params: { column, value: shorten(text.slice(offset)) } };
}

function fieldError(file: string, json: unknown, issue: core.$ZodIssue): SceneError {
  const value = issue.path.reduce<unknown>((part, key) => (part as Record<PropertyKey, unknown>)[key], json);
  const field = issue.path.reduce<string>(
    (path, key) => path + (typeof key === 'number' ? `[${key}]` : String(key)),
    '',
  );
  return {
    code: codeOf(issue, value),
    place: field ? { file, field } : { file },
    params: {
      value: shorten(typeof value === 'number' ? String(value) : (JSON.stringify(value) ?? '')),
      ...('minimum' in issue && { minimum: Number(issue.minimum) }),
      ...('maximum' in issue && { maximum: Number(issue.maximum) }),
    },
  };
}

const typeCodes: Record<string, SceneErrorCode> = {
  object: 'not_an_object',
  array: 'not_a_list',
  string: 'not_a_text',
  number: 'not_a_number',
  int: 'not_a_whole_number',
};

function codeOf(issue: core.$ZodIssue, value: unknown): SceneErrorCode {
  switch (issue.code) {
    case 'too_small':
      if (issue.origin === 'string') return 'empty';
      return issue.inclusive ? 'too_small' : 'not_positive';
    case 'too_big':
      return 'too_large';
    case 'invalid_type':
      return value === undefined ? 'missing' : typeCodes[issue.expected];
    default:
      throw new Error(`the schema of scenes has grown an issue without a sentence: ${issue.code}`);
  }
}

function shorten(text: string): string {
  const [line] = text.split('\n');
  return line.length > 30 ? `${line.slice(0, 30)}…` : line;
}
