/** m, in a picture: x to the right and y downwards. */
export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The points of #P×3, m, seen from the front, a little from the right and from above. */
export function obliquePoints(points: Float64Array): [x: number, y: number][] {
  return Array.from({ length: points.length / 3 }, (_, at) => {
    const [x, y, z] = points.subarray(3 * at, 3 * at + 3);
    const nearness = x * right.sine + z * right.cosine;
    return [x * right.cosine - z * right.sine, nearness * above.sine - y * above.cosine];
  });
}

/** What holds all of them, and a margin of 0.1 m. */
export function boxAround(clouds: readonly Float64Array[]): Box {
  let [left, right, top, bottom] = [
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
    Number.POSITIVE_INFINITY,
    Number.NEGATIVE_INFINITY,
  ];
  for (const cloud of clouds)
    for (const [x, y] of obliquePoints(cloud)) {
      [left, right] = [Math.min(left, x), Math.max(right, x)];
      [top, bottom] = [Math.min(top, y), Math.max(bottom, y)];
    }
  const margin = 0.1;
  return { x: left - margin, y: top - margin, width: right - left + 2 * margin, height: bottom - top + 2 * margin };
}

const right = angle(25);
const above = angle(25);

function angle(degrees: number): { sine: number; cosine: number } {
  return { sine: Math.sin((degrees * Math.PI) / 180), cosine: Math.cos((degrees * Math.PI) / 180) };
}
