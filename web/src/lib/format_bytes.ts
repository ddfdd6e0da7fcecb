import { formatQuantity } from './format.ts';

/** In the unit that suits, powers of 1000: "12 B", "3.05 kB", "94.1 MB". */
export function formatBytes(bytes: number): string {
  if (bytes < 1e3) return `${bytes}\u202fB`;
  if (bytes < 1e6) return formatQuantity(bytes / 1e3, 'kB');
  if (bytes < 1e9) return formatQuantity(bytes / 1e6, 'MB');
  return formatQuantity(bytes / 1e9, 'GB');
}
