/** Differences of positions that a mass has one time step after the other. All #V×3. */

/** m/s: how fast it went from `before` to `now`. */
export function velocity(now: Float64Array, before: Float64Array, delta_t: number): Float64Array {
  return now.map((x, c) => (x - before[c]) / delta_t);
}

/** m/s²: how fast its velocity changed about `now`. */
export function acceleration(next: Float64Array, now: Float64Array, before: Float64Array, delta_t: number) {
  return next.map((x, c) => (x - 2 * now[c] + before[c]) / delta_t ** 2);
}

/** m: where it would be next if nothing pulled at it. */
export function straightOn(now: Float64Array, before: Float64Array): Float64Array {
  return now.map((x, c) => 2 * x - before[c]);
}
