import { computed, signal } from '@preact/signals';
import { state } from './state.ts';

/** A signal that follows a media query. */
function media(query: string) {
  const list = matchMedia(query);
  const matches = signal(list.matches);
  list.addEventListener('change', () => {
    matches.value = list.matches;
  });
  return matches;
}

const systemIsDark = media('(prefers-color-scheme: dark)');

/** What the reader's system asks for. */
export const reducedMotion = media('(prefers-reduced-motion: reduce)');

/** Light or dark, as the reader chose or else as the system has it. */
export const appliedTheme = computed<'light' | 'dark'>(() => {
  const { theme } = state.value;
  return theme === 'system' ? (systemIsDark.value ? 'dark' : 'light') : theme;
});
