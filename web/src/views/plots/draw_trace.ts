import type uPlot from 'uplot';
import type { Phase } from '../../solver/frame.ts';
import type { TracePoint } from './objective_trace.ts';

export interface TraceMarks {
  points: readonly TracePoint[];
  cursorHalfStep: number;
  inspectedHalfStep: number | null;
  /** The trace is of a time step that has passed: drawn in grey, without a cursor. */
  stale: boolean;
}

/**
 * Each half-step's drop as a line in its colour, its end as a marker in its shape: ◆ local, ■ global, ○ predict and accept.
 * `colour` gives the value of one of the page's custom properties.
 */
export function drawTrace(plot: uPlot, marks: TraceMarks, colour: (property: string) => string): void {
  const { ctx, bbox } = plot;
  const { points, cursorHalfStep, inspectedHalfStep, stale } = marks;
  const pixel = devicePixelRatio;
  const x = (halfStep: number) => plot.valToPos(halfStep, 'x', true);
  const y = (height: number) => plot.valToPos(height, 'y', true);
  const colourOf = (phase: Phase) => colour(stale ? '--muted' : phaseColours[phase]);
  const radius = Math.min(5 * pixel, Math.max(2 * pixel, 0.4 * (x(1) - x(0))));

  ctx.save();
  ctx.lineWidth = 1.5 * pixel;
  if (!stale) {
    ctx.strokeStyle = colour('--accent');
    ctx.beginPath();
    ctx.moveTo(x(cursorHalfStep), bbox.top);
    ctx.lineTo(x(cursorHalfStep), bbox.top + bbox.height);
    ctx.stroke();
  }

  points.forEach(({ event, height }, index) => {
    const before = points[index - 1];
    if (height === null || !before || before.height === null) return;
    ctx.strokeStyle = colourOf(event.phase);
    ctx.beginPath();
    ctx.moveTo(x(before.event.half_step), y(before.height));
    ctx.lineTo(x(event.half_step), y(height));
    ctx.stroke();
  });

  for (const { event, height } of points) {
    if (height === null) continue;
    const marker = markerPath(event.phase, x(event.half_step), y(height), radius);
    ctx.fillStyle = isFilled(event.phase) ? colourOf(event.phase) : colour('--background');
    ctx.strokeStyle = colourOf(event.phase);
    ctx.fill(marker);
    ctx.stroke(marker);
    if (!stale && (event.half_step === inspectedHalfStep || event.half_step === cursorHalfStep)) {
      ctx.strokeStyle = colour('--accent');
      ctx.stroke(circle(x(event.half_step), y(height), radius + 4 * pixel));
    }
  }
  ctx.restore();
}

/** A local step solves for d, a global step for p. */
const phaseColours: Record<Phase, string> = {
  predict: '--text',
  local: '--symbol-d',
  global: '--symbol-p',
  accept: '--text',
};

function isFilled(phase: Phase): boolean {
  return phase === 'local' || phase === 'global';
}

/** Shapes of about the same area. */
function markerPath(phase: Phase, x: number, y: number, radius: number): Path2D {
  if (phase === 'local') return diamond(x, y, 1.25 * radius);
  if (phase === 'global') return square(x, y, 0.9 * radius);
  return circle(x, y, radius);
}

function diamond(x: number, y: number, arm: number): Path2D {
  const path = new Path2D();
  path.moveTo(x, y - arm);
  path.lineTo(x + arm, y);
  path.lineTo(x, y + arm);
  path.lineTo(x - arm, y);
  path.closePath();
  return path;
}

function square(x: number, y: number, half: number): Path2D {
  const path = new Path2D();
  path.rect(x - half, y - half, 2 * half, 2 * half);
  return path;
}

function circle(x: number, y: number, radius: number): Path2D {
  const path = new Path2D();
  path.arc(x, y, radius, 0, 2 * Math.PI);
  return path;
}
