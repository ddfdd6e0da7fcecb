import { timeOf } from './time_of.ts';

/** ms. In a page the clock ticks every 0.1 ms. */
const leastTimed_ms = 2;

/** More would make the median hardly steadier, and the page wait. */
const mostRuns = 5;

/** ms after the first run, which finds everything cold. What takes longer is steady enough, and repeated it would keep the solver busy for seconds. */
const patience_ms = 200;

/** ms of one call: the median of a few runs, since a single one tells as much of what else the machine does. */
export function medianTime(call: () => void): number {
  const run = () =>
    timeOf((times) => {
      for (let time = 0; time < times; time++) call();
    }, leastTimed_ms);
  const runs = [run()];
  const started = performance.now();
  while (runs.length < mostRuns && performance.now() - started < patience_ms) runs.push(run());
  runs.sort((a, b) => a - b);
  return runs[Math.floor((runs.length - 1) / 2)];
}
