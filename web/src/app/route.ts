import { signal } from '@preact/signals';

/** Which page is shown. A lesson without a section opens at its first. */
export type Route = { page: 'springs' } | { page: 'lesson'; section: string | null };

export const route = signal<Route>({ page: 'springs' });

const lesson = /^#\/lesson(?:\/([\w-]+))?\/?$/;

/** The page that the path of a fragment names; null where there is none such. */
export function readPath(path: string): Route | null {
  if (['', '#', '#/', '#/springs'].includes(path)) return { page: 'springs' };
  const named = lesson.exec(path);
  return named && { page: 'lesson', section: named[1] ?? null };
}

export function pathOf(to: Route): string {
  if (to.page === 'springs') return '#/springs';
  return to.section === null ? '#/lesson' : `#/lesson/${to.section}`;
}
