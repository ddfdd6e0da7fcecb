import type { Browser, Page } from '@playwright/test';

/** An event of the browser's trace: microseconds, by the clock and of the processor. */
interface TraceEvent {
  name: string;
  pid: number;
  tid: number;
  ts: number;
  tdur?: number;
}

/** What a script on the page calls `performance.mark` with, to say when tasks begin and end to count. */
export const mark = 'e2e-mark';

export async function startTracing(browser: Browser, page: Page): Promise<void> {
  await browser.startTracing(page, { categories: ['disabled-by-default-devtools.timeline', 'blink.user_timing'] });
}

/** ms of the processor, whatever else the machine does, that each task of the page's main thread took from the first mark to the last. */
export async function stopTracing(browser: Browser): Promise<number[]> {
  const { traceEvents } = JSON.parse(String(await browser.stopTracing())) as { traceEvents: TraceEvent[] };
  const marks = traceEvents.filter(({ name }) => name === mark);
  const times = marks.map(({ ts }) => ts);
  const [page] = marks;
  return traceEvents
    .filter(({ name, pid, tid }) => name === 'RunTask' && pid === page.pid && tid === page.tid)
    .filter(({ ts }) => ts > Math.min(...times) && ts < Math.max(...times))
    .map(({ tdur = 0 }) => tdur / 1000);
}
