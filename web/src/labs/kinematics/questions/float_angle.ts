// What single precision makes of the angle θ between two vectors. Every number is a float; Math.fround rounds to it.

/** Between 1 and the next float above it: 2⁻²³. */
const floatEpsilon = 2 ** -23;

/** rad: from the cosine, as a float. The best case: the cosine itself is the float nearest to the true one. */
export function angleFromCosine(theta: number): number {
  return Math.fround(Math.acos(Math.fround(Math.cos(theta))));
}

/** rad: from sine and cosine, as floats. */
export function angleFromBoth(theta: number): number {
  return Math.fround(Math.atan2(Math.fround(Math.sin(theta)), Math.fround(Math.cos(theta))));
}

/** rad: by how much the lab's single precision turns a joint, as graphics libraries do: not at all while the cosine is 1 but for its last bits. */
export function angleTurned(theta: number): number {
  return Math.fround(Math.cos(theta)) >= 1 - floatEpsilon ? 0 : angleFromBoth(theta);
}

/** rad: the smallest true angle, but for a millionth, by which `angle` still gives something. */
export function leastKnown(angle: (theta: number) => number): number {
  let [none, some] = [0, 1];
  while (some - none > 1e-6 * some) {
    const middle = (none + some) / 2;
    if (angle(middle) > 0) some = middle;
    else none = middle;
  }
  return some;
}
