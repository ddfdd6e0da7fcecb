import type uPlot from 'uplot';
import type { Minimiser } from '../../solver/module.ts';
import type { Stop } from '../../solver/stop_of.ts';
import {
  type Abscissa,
  abscissaOf,
  type Curve,
  type CurvePoint,
  drawnPoints,
  heightOf,
  type Ordinate,
} from './comparison_curves.ts';
import { methodStyles } from './method_styles.ts';

export interface CurveMarks {
  curves: readonly Curve[];
  /** Where each method ends this time step; null beyond what was computed. */
  stops: ReadonlyMap<Minimiser, Stop | null>;
  abscissa: Abscissa;
  ordinate: Ordinate;
  /** Both ends of the horizontal axis: iterations, or ms. */
  range: readonly [number, number];
  /** Where the numbers are read off. */
  inspected: number;
  /** The time step has passed: drawn in grey. */
  stale: boolean;
}

/** CSS pixels. */
const markRadius = 5;

/** Each method's line in its colour and dashes, down to the floor where the gap is nothing but rounding, with a dot where the method ends. */
export function drawCurves(plot: uPlot, marks: CurveMarks, colour: (property: string) => string): void {
  const { ctx, bbox } = plot;
  const { abscissa, ordinate, inspected, stale } = marks;
  const pixel = devicePixelRatio;
  const floor = bbox.top + bbox.height;
  const x = (value: number) => plot.valToPos(value, 'x', true);
  const y = (point: CurvePoint) => {
    const height = heightOf(point, ordinate);
    return height === null ? floor : Math.min(floor, plot.valToPos(height, 'y', true));
  };

  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();

  ctx.lineWidth = 1.5 * pixel;
  ctx.strokeStyle = colour('--accent');
  ctx.beginPath();
  ctx.moveTo(x(inspected), bbox.top);
  ctx.lineTo(x(inspected), floor);
  ctx.stroke();

  ctx.lineWidth = 2 * pixel;
  for (const curve of marks.curves) {
    const style = methodStyles[curve.method];
    ctx.strokeStyle = colour(stale ? '--muted' : style.colour);
    ctx.setLineDash(style.dash.map((length) => length * pixel));
    ctx.beginPath();
    for (const point of drawnPoints(curve, ordinate)) {
      const across = abscissaOf(point, abscissa);
      if (abscissa === 'milliseconds' && across === 0) continue; // a log axis has no place for it
      ctx.lineTo(x(across), y(point)); // the first of a path only moves there
    }
    ctx.stroke();
  }
  ctx.restore();

  ctx.save(); // not clipped: a dot on the floor is a whole one
  ctx.lineWidth = 2 * pixel;
  ctx.strokeStyle = colour('--background');
  for (const { method, milliseconds, points } of marks.curves) {
    const stop = marks.stops.get(method);
    if (!stop) continue;
    const across = abscissa === 'iterations' ? stop.iterations : stop.iterations * milliseconds;
    if (across > marks.range[1] || (abscissa === 'milliseconds' && across === 0)) continue;
    const point = points[Math.min(stop.iterations, points.length - 1)]; // once E falls no further, nothing changes
    ctx.fillStyle = colour(stale ? '--muted' : methodStyles[method].colour);
    ctx.beginPath();
    ctx.arc(x(across), y(point), markRadius * pixel, 0, 2 * Math.PI);
    ctx.fill();
    ctx.stroke();
  }
  ctx.restore();
}
