import type { Ink } from './types.ts';

/** The page's present colours and size of type; `kinds` names custom properties. */
export function inkOf(kinds: readonly (readonly string[])[]): Ink {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string) => style.getPropertyValue(name).trim();
  return {
    background: colour('--background'),
    text: colour('--text'),
    muted: colour('--muted'),
    line: colour('--line'),
    accent: colour('--accent'),
    typeScale: Number.parseFloat(style.fontSize) / 16,
    kinds: kinds.map((names) => names.map(colour)),
  };
}
