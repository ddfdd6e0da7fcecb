/**
 * ms of one repetition, among as many as take `leastTimed` ms together: a page's clock ticks seldom. The better of two, since the first finds the
 * caches cold; and if it was only held up by something else, more repetitions are needed after all.
 */
export function timeOf(repeat: (times: number) => void, leastTimed: number): number {
  const timed = (times: number) => {
    const started = performance.now();
    repeat(times);
    return performance.now() - started;
  };
  for (let times = 1; ; times *= 2) {
    const first = timed(times);
    if (first < leastTimed) continue;
    const better = Math.min(first, timed(times));
    if (better >= leastTimed / 2) return better / times;
  }
}
