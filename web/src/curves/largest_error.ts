import { type Curve, distance, type Point2 } from './curve.ts';
import { type Gap, gapsOf } from './gaps.ts';
import type { SampledCurve } from './sample_curve.ts';

/** Even, so that the middle of an arc is among what is looked at. */
const stepsInGap = 32;

/** How far, in m, the curve departs from the lines between its points. */
export function largestError(sampled: SampledCurve, curve: Curve): number {
  let largest = 0;
  for (const gap of gapsOf(sampled, curve))
    for (const t of parametersIn(gap)) {
      const off = distanceToLine(gap.stroke.at(t), gap.start, gap.end);
      if (off > largest) largest = off;
    }
  return largest;
}

function parametersIn({ from, to, stroke }: Gap): number[] {
  const even = Array.from({ length: stepsInGap - 1 }, (_, k) => from + ((to - from) * (k + 1)) / stepsInGap);
  return [...even, ...stroke.corners.filter((corner) => from < corner && corner < to)];
}

/** To the nearest point of the line between `start` and `end`. */
function distanceToLine(point: Point2, start: Point2, end: Point2): number {
  const along: Point2 = [end[0] - start[0], end[1] - start[1]];
  const square = along[0] ** 2 + along[1] ** 2;
  if (square === 0) return distance(point, start);
  const share = ((point[0] - start[0]) * along[0] + (point[1] - start[1]) * along[1]) / square;
  const inside = Math.min(Math.max(share, 0), 1);
  return distance(point, [start[0] + inside * along[0], start[1] + inside * along[1]]);
}
