import { signal } from '@preact/signals';

/** The joint of the arm that is pointed at, in the picture or in the equations: both light it. */
export const pointedJoint = signal<number | null>(null);
