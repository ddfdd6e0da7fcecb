import { signal } from '@preact/signals';
import type { MessageKey } from './messages/index.ts';

/** A sentence for the reader: what happened, where, and the value. Kept as key and parameters so that it follows the language. */
export interface Notice {
  id: number;
  kind: 'error' | 'info';
  key: MessageKey;
  params: Record<string, string | number>;
}

export const notices = signal<Notice[]>([]);

/** ms: long enough to be read twice. */
const lifetime = { info: 6_000, error: 15_000 };

/** More than this on screen at once is noise; the oldest goes. */
const most = 3;
let count = 0;

export function notify(kind: Notice['kind'], key: MessageKey, params: Notice['params'] = {}): void {
  const others = notices.value.filter((notice) => notice.key !== key);
  const id = count++;
  notices.value = [...others, { id, kind, key, params }].slice(-most);
  setTimeout(() => expire(id), lifetime[kind]);
}

/** The reader tries something else: what was wrong with the last try is over. */
export function dismissErrors(): void {
  notices.value = notices.value.filter(({ kind }) => kind !== 'error');
}

/** Whether the reader's pointer or focus is on the notices: nothing vanishes while it is being read. */
export const reading = signal(false);

function expire(id: number): void {
  if (reading.value) setTimeout(() => expire(id), lifetime.info);
  else dismiss(id);
}

export function dismiss(id: number): void {
  notices.value = notices.value.filter((notice) => notice.id !== id);
}
