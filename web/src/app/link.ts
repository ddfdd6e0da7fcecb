import { sameJson } from '../lib/same_json.ts';
import { pathOf, type Route, readPath, springsRoute } from './route.ts';
import { stateSchema } from './schema.ts';
import { type AppState, defaultState } from './state.ts';

/** A link longer than this is not read: no state of ours comes near it. */
export const longestLink = 64 * 1024;

/** Why a part of a link was not used. */
export type LinkProblem = { part: string; value: string } | { tooLong: number };

/** The parts of the state that a link to a page carries: of each lab its own, and the lesson's figures are not among them. */
const partsOf: Record<Route['page'], readonly (keyof AppState)[]> = {
  springs: (Object.keys(stateSchema) as (keyof AppState)[]).filter(
    (part) => part !== 'integrators' && part !== 'kinematics',
  ),
  integrators: ['version', 'integrators', 'language', 'theme'],
  kinematics: ['version', 'kinematics', 'language', 'theme'],
  lesson: ['language', 'theme'],
};

/** Named in every link: what a reader's own preferences would otherwise replace. */
const alwaysNamed: readonly (keyof AppState)[] = ['version', 'scene', 'integrators', 'kinematics', 'language'];

/** The address's fragment for a page and a state: every part that is not the default, as JSON. */
export function encodeLink(route: Route, state: AppState): string {
  const query = partsOf[route.page]
    .filter((part) => alwaysNamed.includes(part) || !sameJson(state[part], defaultState[part]))
    .map((part) => `${part}=${escapePart(JSON.stringify(state[part]))}`);
  return `${pathOf(route)}?${query.join('&')}`;
}

export interface Link {
  route: Route;
  state: AppState;
  problems: LinkProblem[];
}

/** What a fragment asks for: parts that it does not name, or that do not pass the schema, keep their value in `fallback`. */
export function decodeLink(fragment: string, fallback: AppState): Link {
  if (fragment.length > longestLink)
    return { route: springsRoute, state: fallback, problems: [{ tooLong: fragment.length }] };
  const problems: LinkProblem[] = [];
  const path = fragment.split('?')[0];
  const named = readPath(path);
  const route = named ?? springsRoute;
  if (!named) problems.push({ part: '#', value: readable(path).slice(0, 60) });
  const state: Record<string, unknown> = { ...fallback };
  const query = fragment.includes('?') ? fragment.slice(fragment.indexOf('?') + 1) : '';
  for (const item of query.split('&').filter(Boolean)) {
    const [part = '', ...rest] = item.split('=');
    const value = rest.join('=');
    const known = partsOf[route.page].find((name) => name === part);
    const read = known && readPart(known, value);
    if (read) state[part] = read.value;
    else problems.push({ part, value: readable(value).slice(0, 60) });
  }
  return { route, state: state as unknown as AppState, problems };
}

function readPart(part: keyof AppState, text: string): { value: unknown } | null {
  try {
    const result = stateSchema[part].safeParse(JSON.parse(decodeURIComponent(text)));
    return result.success ? { value: result.data } : null;
  } catch {
    return null; // broken percent escapes or JSON
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
