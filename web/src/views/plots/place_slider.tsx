import { t } from '../../app/messages/index.ts';
import type { Abscissa } from './comparison_curves.ts';

interface Props {
  abscissa: Abscissa;
  range: readonly [number, number];
  place: number;
  /** The place and what stands there. */
  text: string;
  /** Null: no longer any. */
  onChoose: (place: number | null) => void;
}

/** Positions of the slider on the logarithmic axis of time. */
const ticks = 100;

/** What pointing at the plot does, for the keyboard. */
export function PlaceSlider({ abscissa, range: [first, last], place, text, onChoose }: Props) {
  const inTime = abscissa === 'milliseconds';
  const toTick = (time: number) => Math.round((ticks * Math.log(time / first)) / Math.log(last / first));
  const fromTick = (tick: number) => first * (last / first) ** (tick / ticks);
  return (
    <input
      type="range"
      class="visually-hidden"
      aria-label={t('plots.comparison.inspect')}
      aria-valuetext={text}
      min={inTime ? 0 : first}
      max={inTime ? ticks : last}
      value={inTime ? toTick(place) : place}
      onInput={({ currentTarget: { valueAsNumber } }) => onChoose(inTime ? fromTick(valueAsNumber) : valueAsNumber)}
      onBlur={() => onChoose(null)}
    />
  );
}
