import type uPlot from 'uplot';
import { formatPowerOfTen } from '../../lib/format.ts';
import { decadeTicks } from './log_axis.ts';

/** How the page around a plot looks, read when asked. */
export interface PageStyle {
  /** The value of one of the page's custom properties. */
  colour(property: string): string;
  axis: uPlot.Axis;
}

export function pageStyle(host: HTMLElement): PageStyle {
  const style = getComputedStyle(host);
  const colour = (property: string) => style.getPropertyValue(property);
  const pixels = Math.round(0.8 * Number.parseFloat(style.fontSize)); // uPlot reads no fractions
  const axis: uPlot.Axis = {
    font: `${pixels}px ${style.fontFamily}`,
    stroke: () => colour('--muted'),
    grid: { stroke: () => colour('--line'), width: 1 },
    ticks: { stroke: () => colour('--line'), width: 1, size: 4 },
  };
  return { colour, axis };
}

/** Powers of ten, at least `spacing` CSS pixels apart on an axis `length` CSS pixels long. */
export function powersOfTen(spacing: number, length: (plot: uPlot) => number): uPlot.Axis {
  return {
    splits: (plot, _, lowest, highest) => decadeTicks(lowest, highest, length(plot) / spacing).map((n) => 10 ** n),
    filter: (_, ticks) => ticks,
    values: (_, ticks) => ticks.map((tick) => formatPowerOfTen(Math.round(Math.log10(tick)))),
  };
}
