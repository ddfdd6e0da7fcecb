import { stateSchema } from './schema.ts';
import { type AppState, defaultState } from './state.ts';

/** A link longer than this is not read: no state of ours comes near it. */
export const longestLink = 64 * 1024;

/** Why a part of a link was not used. */
export type LinkProblem = { part: string; value: string } | { tooLong: number };

const route = '#/springs';
const parts = Object.keys(stateSchema) as (keyof AppState)[];

/** Named in every link: what a reader's own preferences would otherwise replace. */
const alwaysNamed: readonly (keyof AppState)[] = ['version', 'scene', 'language'];

/** The address's fragment for a state: every part that is not the default, as JSON. */
export function encodeLink(state: AppState): string {
  const query = parts
    .filter((part) => alwaysNamed.includes(part) || !same(state[part], defaultState[part]))
    .map((part) => `${part}=${escapePart(JSON.stringify(state[part]))}`);
  return `${route}?${query.join('&')}`;
}

/** The state a fragment asks for: parts it does not name, or that do not pass the schema, keep their value in `fallback`. */
export function decodeLink(fragment: string, fallback: AppState): { state: AppState; problems: LinkProblem[] } {
  if (fragment.length > longestLink) return { state: fallback, problems: [{ tooLong: fragment.length }] };
  const problems: LinkProblem[] = [];
  const asked = fragment.split('?')[0];
  if (!['', '#', '#/', route].includes(asked)) problems.push({ part: '#', value: readable(asked).slice(0, 60) });
  const state: Record<string, unknown> = { ...fallback };
  const query = fragment.includes('?') ? fragment.slice(fragment.indexOf('?') + 1) : '';
  for (const item of query.split('&').filter(Boolean)) {
    const [part = '', ...rest] = item.split('=');
    const value = rest.join('=');
    const read = readPart(part, value);
    if (read.ok) state[part] = read.value;
    else problems.push({ part, value: readable(value).slice(0, 60) });
  }
  return { state: state as unknown as AppState, problems };
}

function readPart(part: string, text: string): { ok: true; value: unknown } | { ok: false } {
  const schema = parts.find((known) => known === part);
  if (!schema) return { ok: false };
  try {
    const result = stateSchema[schema].safeParse(JSON.parse(decodeURIComponent(text)));
    return result.success ? { ok: true, value: result.data } : { ok: false };
  } catch {
    return { ok: false }; // broken percent escapes or JSON
  }
}

/** What was written before something percent-encoded it, where that can be told. */
function readable(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** Escapes only what a fragment cannot carry, so that links stay readable. */
function escapePart(json: string): string {
  return json.replace(/[%&#+\s"<>`^|\\]|[^\x20-\x7e]/gu, encodeURIComponent);
}

function same(a: unknown, b: unknown): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
