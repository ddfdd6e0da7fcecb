/**
 * ms of one repetition, among as many as take `leastTimed` ms together: a page's clock ticks seldom. The better of two, since the first finds the
 * caches cold.
 */
export function timeOf(repeat: (times: number) => void, leastTimed: number): number {
  const timed = (times: number) => {
    const started = performance.now();
    repeat(times);
    return performance.now() - started;
  };
  for (let times = 1; ; times *= 2) {
    const first = timed(times);
    if (first >= leastTimed) return Math.min(first, timed(times)) / times;
  }
}
