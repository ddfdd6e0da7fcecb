import { t } from '../../../app/messages/index.ts';
import { formatNumber } from '../../../lib/format.ts';
import { RangeInput } from '../../../lib/range_input.tsx';
import { symbolCommand } from '../../../notation/macros.ts';
import type { SymbolId } from '../../../notation/symbols.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import type { FigureSession } from './figure_session.ts';

/** What a small scene can be asked for without the picture being left. */
const ranges = {
  k: { min: 20, max: 2000, unit: 'N/m', symbol: 'k' },
  delta_t: { min: 1 / 240, max: 1, unit: 's', symbol: 'deltaT' },
  mass_scale: { min: 0.1, max: 10, unit: '×', symbol: 'm' },
  w: { min: 1e2, max: 1e10, unit: 'N/m', symbol: 'w' },
  iterations: { min: 1, max: 50, unit: '', symbol: null },
} as const satisfies Record<string, { min: number; max: number; unit: string; symbol: SymbolId | null }>;

export type SliderName = keyof typeof ranges;

/** Positions of a slider that spans decades, so that they are equal factors. A count has its own values for positions: no key press may be lost. */
const ticks = 200;

/** One parameter of a figure. */
export function FigureSlider({ figure, name }: { figure: FigureSession; name: SliderName }) {
  const { min, max, unit, symbol } = ranges[name];
  const value = figure.parameters.value[name];
  const counts = name === 'iterations';
  const [first, last] = counts ? [min, max] : [0, ticks];
  const tick = counts ? value : Math.round((ticks * Math.log(value / min)) / Math.log(max / min));
  const shown = `${formatNumber(value)} ${unit}`;
  const set = (next: number) =>
    figure.setParameter(name, counts ? next : Number((min * (max / min) ** (next / ticks)).toPrecision(3)));
  return (
    <label class="figure-slider">
      <span>
        {symbol ? <Formula tex={symbolCommand(symbol)} /> : <i>K</i>} {t(`page.controls.${name}`)}
      </span>
      <RangeInput min={first} max={last} value={tick} aria-valuetext={shown} onValue={set} />
      <output>{counts ? value : shown}</output>
    </label>
  );
}
