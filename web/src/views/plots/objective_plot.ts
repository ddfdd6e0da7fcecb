import uPlot from 'uplot';
import { formatPowerOfTen } from '../../lib/format.ts';
import { drawTrace, type TraceMarks } from './draw_trace.ts';
import { decadesAround, decadeTicks } from './log_axis.ts';

export interface ObjectivePlotCallbacks {
  /** The reader points at a half-step, or no longer at any. */
  onInspect(halfStep: number | null): void;
  /** The reader clicks a half-step. */
  onSeek(halfStep: number): void;
}

export interface ObjectivePlotState extends TraceMarks {
  lastHalfStep: number;
}

/** Objective against half-steps on a log axis. One owner makes it and destroys it. */
export class ObjectivePlot {
  private state: ObjectivePlotState = {
    points: [],
    cursorHalfStep: 0,
    lastHalfStep: 1,
    inspectedHalfStep: null,
    stale: false,
  };
  private plot: uPlot;
  private readonly host: HTMLElement;
  private readonly callbacks: ObjectivePlotCallbacks;

  constructor(host: HTMLElement, callbacks: ObjectivePlotCallbacks) {
    this.host = host;
    this.callbacks = callbacks;
    this.plot = this.build();
  }

  update(state: ObjectivePlotState): void {
    const sameTrace = state.points === this.state.points && state.lastHalfStep === this.state.lastHalfStep;
    this.state = state;
    if (sameTrace) this.plot.redraw(false);
    else this.plot.setData(this.data());
  }

  /** Call when the host's size has changed. The page's type may have grown with it, and uPlot takes fonts only when built. */
  resize(): void {
    this.plot.destroy();
    this.plot = this.build();
  }

  /** Call when the page's colours have changed. */
  setTheme(): void {
    this.plot.redraw(false, true);
  }

  destroy(): void {
    this.plot.destroy();
  }

  private data(): uPlot.AlignedData {
    const { points } = this.state;
    return [points.map(({ event }) => event.half_step), points.map(({ height }) => height)];
  }

  private build(): uPlot {
    const style = getComputedStyle(this.host);
    const colour = (name: string) => style.getPropertyValue(name);
    const pixels = Math.round(0.8 * Number.parseFloat(style.fontSize)); // uPlot reads no fractions
    const axis: uPlot.Axis = {
      font: `${pixels}px ${style.fontFamily}`,
      stroke: () => colour('--muted'),
      grid: { stroke: () => colour('--line'), width: 1 },
      ticks: { stroke: () => colour('--line'), width: 1, size: 4 },
    };
    const options: uPlot.Options = {
      width: this.host.clientWidth,
      height: this.host.clientHeight,
      legend: { show: false },
      cursor: { y: false, points: { show: false }, drag: { x: false, setScale: false } },
      scales: {
        x: { time: false, range: () => [-0.5, this.state.lastHalfStep + 0.5] },
        y: { distr: 3, range: (_, lowest, highest) => decadesAround(lowest, highest) },
      },
      axes: [
        { ...axis, size: 28, incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] },
        {
          ...axis,
          size: 52,
          splits: (plot, _, lowest, highest) => decadeTicks(lowest, highest, plot.height / 28).map((n) => 10 ** n),
          filter: (_, ticks) => ticks,
          values: (_, ticks) => ticks.map((tick) => formatPowerOfTen(Math.round(Math.log10(tick)))),
        },
      ],
      series: [{}, { paths: () => null, points: { show: false } }],
      hooks: {
        draw: [(plot) => drawTrace(plot, this.state, colour)],
        setCursor: [(plot) => this.callbacks.onInspect(pointedHalfStep(plot))],
        ready: [(plot) => plot.over.addEventListener('click', () => this.seek(pointedHalfStep(plot)))],
      },
    };
    return new uPlot(options, this.data(), this.host);
  }

  private seek(halfStep: number | null): void {
    if (halfStep !== null) this.callbacks.onSeek(halfStep);
  }
}

function pointedHalfStep({ cursor, data }: uPlot): number | null {
  return cursor.idx == null ? null : (data[0][cursor.idx] ?? null);
}
