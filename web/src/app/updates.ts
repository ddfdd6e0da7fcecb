import { registerSW } from 'virtual:pwa-register';
import { signal } from '@preact/signals';

/** A new version of the page has been fetched and waits. */
export const updateWaiting = signal(false);

let update: (reload: boolean) => Promise<void> = async () => {};

/** Keeps the page for use without a network, and looks for new versions of it. */
export function keepOffline(): void {
  update = registerSW({
    onNeedRefresh: () => {
      updateWaiting.value = true;
    },
  });
}

/** Loads the version that waits. */
export function applyUpdate(): void {
  void update(true);
}
