import { signal } from '@preact/signals';

/** What the keys of the lab's clock do in a room that has a clock of its own: returns whether the key meant something. Null elsewhere. */
export const roomKeys = signal<((key: string) => boolean) | null>(null);
