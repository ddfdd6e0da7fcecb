import type uPlot from 'uplot';
import { type Abscissa, abscissaOf, type Curve } from './comparison_curves.ts';
import { methodStyles } from './method_styles.ts';

export interface CurveMarks {
  curves: readonly Curve[];
  abscissa: Abscissa;
  /** Where the numbers are read off. */
  inspected: number;
  /** The time step has passed: drawn in grey. */
  stale: boolean;
}

/** Each method's line in its colour and dashes, down to the floor where the gap is nothing but rounding. */
export function drawCurves(plot: uPlot, marks: CurveMarks, colour: (property: string) => string): void {
  const { ctx, bbox } = plot;
  const pixel = devicePixelRatio;
  const floor = bbox.top + bbox.height;
  const x = (value: number) => plot.valToPos(value, 'x', true);
  const y = (gap: number | null) => (gap === null ? floor : plot.valToPos(gap, 'y', true));

  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();

  ctx.lineWidth = 1.5 * pixel;
  ctx.strokeStyle = colour('--accent');
  ctx.beginPath();
  ctx.moveTo(x(marks.inspected), bbox.top);
  ctx.lineTo(x(marks.inspected), floor);
  ctx.stroke();

  ctx.lineWidth = 2 * pixel;
  for (const { method, points } of marks.curves) {
    const style = methodStyles[method];
    ctx.strokeStyle = colour(marks.stale ? '--muted' : style.colour);
    ctx.setLineDash(style.dash.map((length) => length * pixel));
    ctx.beginPath();
    for (const point of points) {
      const abscissa = abscissaOf(point, marks.abscissa);
      if (marks.abscissa === 'milliseconds' && abscissa === 0) continue; // a log axis has no place for it
      ctx.lineTo(x(abscissa), y(point.gap)); // the first of a path only moves there
    }
    ctx.stroke();
  }
  ctx.restore();
}
