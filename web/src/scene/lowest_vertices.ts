/** Of the height of the whole: the sole. Of the rabbits, 6 to 8 of 100 vertices lie in it. */
const sole = 0.03;

/** What a solid stands on: all vertices within a small part of its height from the lowest, ascending. V is #V by 3, y upwards. */
export function lowestVertices(V: Float64Array): number[] {
  const y = V.filter((_, entry) => entry % 3 === 1);
  const bottom = y.reduce((least, height) => Math.min(least, height), Number.POSITIVE_INFINITY);
  const top = y.reduce((most, height) => Math.max(most, height), Number.NEGATIVE_INFINITY);
  return [...y.keys()].filter((i) => y[i] <= bottom + sole * (top - bottom));
}
