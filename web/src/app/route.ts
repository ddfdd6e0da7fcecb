import { signal } from '@preact/signals';

/** What of the springs lab is shown instead of its main screen; all see the same simulation. */
export const rooms = ['matrices', 'convergence', 'misconceptions'] as const;
export type Room = (typeof rooms)[number];

/** Which page is shown. A lesson without a section opens at its first, the lab without a room at its main screen. */
export type Route =
  | { page: 'springs'; room: Room | null }
  | { page: 'integrators' }
  | { page: 'kinematics' }
  | { page: 'lesson'; section: string | null };

export const springsRoute: Route = { page: 'springs', room: null };
export const integratorsRoute: Route = { page: 'integrators' };
export const kinematicsRoute: Route = { page: 'kinematics' };

/** Whether a page simulates scenes, of which one is chosen. */
export function hasScenes({ page }: Route): boolean {
  return page === 'springs' || page === 'integrators';
}

export const route = signal<Route>(springsRoute);

const springs = /^#?\/?$|^#\/springs(?:\/([\w-]+))?\/?$/;
const integrators = /^#\/integrators\/?$/;
const kinematics = /^#\/kinematics\/?$/;
const lesson = /^#\/lesson(?:\/([\w-]+))?\/?$/;

/** The page that the path of a fragment names; null where there is none such. */
export function readPath(path: string): Route | null {
  const lab = springs.exec(path);
  if (lab) {
    const room = rooms.find((name) => name === lab[1]) ?? null;
    return room === null && lab[1] !== undefined ? null : { page: 'springs', room };
  }
  if (integrators.test(path)) return integratorsRoute;
  if (kinematics.test(path)) return kinematicsRoute;
  const named = lesson.exec(path);
  return named && { page: 'lesson', section: named[1] ?? null };
}

export function pathOf(to: Route): string {
  if (to.page === 'springs') return to.room === null ? '#/springs' : `#/springs/${to.room}`;
  if (to.page === 'integrators') return '#/integrators';
  if (to.page === 'kinematics') return '#/kinematics';
  return to.section === null ? '#/lesson' : `#/lesson/${to.section}`;
}
