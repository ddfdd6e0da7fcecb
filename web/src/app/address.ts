import { effect } from '@preact/signals';
import { decodeLink, encodeLink, type Link, longestLink } from './link.ts';
import { notify } from './notices.ts';
import { route } from './route.ts';
import { defaultState, state } from './state.ts';

/** Browsers throttle writes to the address; a drag would make hundreds. */
const quiet_ms = 300;

/** The page and state that an address asks for, in the reader's language and theme, and with the other labs as they are, where it names none; what it asks wrongly is said in a notice. */
export function readAddress({ hash }: URL | Location): Link {
  const { language, theme, integrators, kinematics } = state.value;
  const link = decodeLink(hash, { ...defaultState, language, theme, integrators, kinematics });
  for (const problem of link.problems) {
    if ('tooLong' in problem)
      notify('error', 'page.errors.linkTooLong', { length: problem.tooLong, most: longestLink });
    else notify('error', 'page.errors.linkPart', problem);
  }
  return link;
}

/** Keeps the address equal to page and state, so that copying it is sharing it. `follow` hears of links typed or clicked later. */
export function followAddress(follow: (link: Link) => Promise<unknown>): void {
  let timer = 0;
  effect(() => {
    const link = encodeLink(route.value, state.value);
    clearTimeout(timer);
    timer = window.setTimeout(() => history.replaceState(null, '', link), quiet_ms);
  });
  addEventListener('hashchange', async ({ newURL }) => {
    await follow(readAddress(new URL(newURL))); // the address itself may have been rewritten by now
    history.replaceState(null, '', encodeLink(route.value, state.value)); // what could not be opened does not stay in it
  });
}
