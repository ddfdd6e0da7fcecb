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

/** More than this on screen at once is noise; the oldest goes. */
const most = 3;
let count = 0;

export function notify(kind: Notice['kind'], key: MessageKey, params: Notice['params'] = {}): void {
  const others = notices.value.filter((notice) => notice.key !== key);
  notices.value = [...others, { id: count++, kind, key, params }].slice(-most);
}

export function dismiss(id: number): void {
  notices.value = notices.value.filter((notice) => notice.id !== id);
}
