import { createContext } from 'preact';
import type { Actions } from '../../app/actions.ts';

/** What the lesson can do to the rest of the page: figures open themselves in the lab. Null outside the lesson. */
export const LessonActions = createContext<Actions | null>(null);
