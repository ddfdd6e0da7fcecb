import { computed, signal } from '@preact/signals';
import type { Progress } from '../solver/protocol.ts';

/** Gives up the files of a scene that are being read; null while there are none. */
export const reading = signal<AbortController | null>(null);

/** What the solver's present request is at; null between requests, and while one has told nothing. */
export const solving = signal<Progress | null>(null);

/** What the reader may have to wait for. Nobody knows how long files will be. */
export const work = computed<Progress | { stage: 'reading'; fraction: 0 } | null>(() =>
  reading.value ? { stage: 'reading', fraction: 0 } : solving.value,
);
