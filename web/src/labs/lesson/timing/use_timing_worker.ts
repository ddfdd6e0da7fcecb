import { useSignal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { inTimingWorker, type TimingTask } from '../../../app/in_timing_worker.ts';

/** A button's way to the timing worker: one task at a time, ended by `stop` or when the component goes. */
export function useTimingWorker() {
  const running = useSignal<AbortController | null>(null);
  const failure = useSignal<unknown>(null);
  const stop = () => running.value?.abort();

  /** Null when it was stopped or failed; `failure` then says why. */
  async function run<T>(task: TimingTask<T>): Promise<T | null> {
    const controller = new AbortController();
    running.value = controller;
    failure.value = null;
    try {
      return await inTimingWorker(controller.signal, task);
    } catch (reason) {
      failure.value = reason;
      return null;
    } finally {
      running.value = null;
    }
  }

  useEffect(() => stop, []);
  return { running: running.value !== null, failure: failure.value, run, stop };
}
