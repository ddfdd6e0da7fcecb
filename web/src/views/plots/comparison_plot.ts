import uPlot from 'uplot';
import { abscissaOf, drawnPoints, heightOf } from './comparison_curves.ts';
import { type CurveMarks, drawCurves } from './draw_curves.ts';
import { decadesAround } from './log_axis.ts';
import { pageStyle, powersOfTen } from './plot_axes.ts';
import type { Plot } from './use_plot.ts';

/** The curves are drawn by us, each with an abscissa of its own; uPlot draws the axes, and does so only where there are data. */
const noData: uPlot.AlignedData = [
  [1, 2],
  [1, 1],
];

/** E(p^k) − E* or ‖∂E/∂p^k‖∞ on a log axis, against iterations or, on another log axis, against ms. One owner makes it and destroys it. */
export class ComparisonPlot implements Plot<CurveMarks> {
  private state: CurveMarks = {
    curves: [],
    stops: new Map(),
    abscissa: 'iterations',
    ordinate: 'gap',
    range: [0, 1],
    inspected: 0,
    stale: false,
  };
  private plot: uPlot;
  private readonly host: HTMLElement;
  /** The reader points at a place of the horizontal axis. */
  private readonly onInspect: (abscissa: number) => void;

  constructor(host: HTMLElement, onInspect: (abscissa: number) => void) {
    this.host = host;
    this.onInspect = onInspect;
    this.plot = this.build();
  }

  update(state: CurveMarks): void {
    const sameAxis = state.abscissa === this.state.abscissa;
    this.state = state;
    if (sameAxis) this.plot.setData(noData);
    else this.resize();
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

  private build(): uPlot {
    const { axis, colour } = pageStyle(this.host);
    const inTime = this.state.abscissa === 'milliseconds';
    const options: uPlot.Options = {
      width: this.host.clientWidth,
      height: this.host.clientHeight,
      legend: { show: false },
      cursor: { x: false, y: false, points: { show: false }, drag: { x: false, setScale: false } },
      scales: {
        x: { time: false, distr: inTime ? 3 : 1, range: () => [...this.state.range] },
        y: { distr: 3, range: () => this.decades() },
      },
      axes: [
        { ...axis, size: 28, ...(inTime && powersOfTen(48, ({ width }) => width)) },
        { ...axis, size: 52, ...powersOfTen(28, ({ height }) => height) },
      ],
      series: [{}, { paths: () => null, points: { show: false } }],
      hooks: {
        draw: [(plot) => drawCurves(plot, this.state, colour)],
        setCursor: [(plot) => this.inspect(plot)],
      },
    };
    return new uPlot(options, noData, this.host);
  }

  private decades(): [number, number] {
    const { curves, abscissa, ordinate, range } = this.state;
    const heights = curves
      .flatMap((curve) => drawnPoints(curve, ordinate))
      .filter((point) => abscissaOf(point, abscissa) <= range[1])
      .flatMap((point) => heightOf(point, ordinate) ?? []);
    return heights.length > 0 ? decadesAround(Math.min(...heights), Math.max(...heights)) : decadesAround(null, null);
  }

  private inspect({ cursor: { left = -1 }, posToVal }: uPlot): void {
    if (left >= 0) this.onInspect(posToVal(left, 'x')); // negative: the pointer has left
  }
}
