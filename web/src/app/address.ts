import { effect } from '@preact/signals';
import { decodeLink, encodeLink, longestLink } from './link.ts';
import { preferredLanguage } from './messages/index.ts';
import { notify } from './notices.ts';
import { type AppState, defaultState, state } from './state.ts';

/** Browsers throttle writes to the address; a drag would make hundreds. */
const quiet_ms = 300;

/** The state that the page's address asks for; what it asks wrongly is said in a notice. */
export function readAddress(): AppState {
  const fallback = { ...defaultState, language: preferredLanguage(navigator.languages) };
  const { state: asked, problems } = decodeLink(location.hash, fallback);
  for (const problem of problems) {
    if ('tooLong' in problem)
      notify('error', 'page.errors.linkTooLong', { length: problem.tooLong, most: longestLink });
    else notify('error', 'page.errors.linkPart', problem);
  }
  return asked;
}

/** Keeps the address equal to the state, so that copying it is sharing it. `onEdited` hears of links typed or clicked later. */
export function followAddress(onEdited: () => Promise<unknown>): void {
  let timer = 0;
  effect(() => {
    const link = encodeLink(state.value);
    clearTimeout(timer);
    timer = window.setTimeout(() => history.replaceState(null, '', link), quiet_ms);
  });
  addEventListener('hashchange', async () => {
    await onEdited();
    history.replaceState(null, '', encodeLink(state.value)); // what could not be opened does not stay in the address
  });
}
