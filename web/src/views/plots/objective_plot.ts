import uPlot from 'uplot';
import { drawTrace, type TraceMarks } from './draw_trace.ts';
import { decadesAround } from './log_axis.ts';
import { pageStyle, powersOfTen } from './plot_axes.ts';
import type { Plot } from './use_plot.ts';

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
export class ObjectivePlot implements Plot<ObjectivePlotState> {
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

  /** The page's type may have grown with the host, and uPlot takes fonts only when built. */
  resize(): void {
    this.plot.destroy();
    this.plot = this.build();
  }

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
    const { axis, colour } = pageStyle(this.host);
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
        { ...axis, size: 52, ...powersOfTen(28, ({ height }) => height) },
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
