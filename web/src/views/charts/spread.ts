/** Places on a line, px, moved apart to at least `gap` and into the range, in the order in which they were. */
export function spread(
  wanted: readonly number[],
  gap: number,
  [min, max]: readonly [min: number, max: number],
): number[] {
  const places = [...wanted];
  const order = [...wanted.keys()].sort((a, b) => wanted[a] - wanted[b]);
  let least = min;
  for (const at of order) {
    places[at] = Math.max(places[at], least);
    least = places[at] + gap;
  }
  let most = max;
  for (const at of order.reverse()) {
    places[at] = Math.min(places[at], most);
    most = places[at] - gap;
  }
  return places;
}
