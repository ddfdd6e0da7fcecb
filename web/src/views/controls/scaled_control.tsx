import type { ComponentChildren } from 'preact';
import { Icon } from '../../lib/icon.tsx';
import { RangeInput } from '../../lib/range_input.tsx';
import type { SymbolId } from '../../notation/symbols.ts';
import { NumberField, showNumber } from './number_field.tsx';
import './controls.css';

interface Props {
  id: string;
  /** The letter, if it has one, and its symbol in the equations, if it stands there: they share the colour. */
  letter: string;
  symbol: SymbolId | null;
  name: string;
  unit: string;
  value: number;
  /** Of the field. From 0 on: the slider begins with 0 and then spans decades like all others. */
  limits: Range;
  /** Of the slider, where it should not span all that the field takes. */
  reach?: Range;
  whole?: boolean;
  /** Not in use at present: what is said about it. */
  unused?: string | undefined;
  onSet: (value: number) => void;
  /** The way back to the usual value; `onReset` is null where it is that already. */
  reset: { label: string; onReset: (() => void) | null };
}

interface Range {
  min: number;
  max: number;
}

/** Positions of the slider. */
const ticks = 1000;

/** One number: slider for the feel of it, field for the exact value, and the way back. */
export function ScaledControl(props: Props) {
  const { id, letter, symbol, name, unit, value, limits, reach = limits, whole = false, unused, onSet, reset } = props;
  const text = `${showNumber(value)} ${unit}`;
  const tick = toTick(value, reach);
  return (
    <div class={unused ? 'parameter unused' : 'parameter'}>
      <label for={id}>
        {letter && (
          <i class="symbol" data-sym={symbol ?? undefined}>
            {letter}
          </i>
        )}
        {name}
        {unused && <UnusedNote>{unused}</UnusedNote>}
      </label>
      <RangeInput
        min={0}
        max={ticks}
        value={tick}
        aria-label={name}
        aria-valuetext={unused ? `${text}, ${unused}` : text}
        onValue={(place) => {
          const next = fromTick(place, reach);
          onSet(whole ? Math.round(next) : round(next));
        }}
      />
      <NumberField id={id} value={value} {...limits} whole={whole} unit={unit} onSet={onSet}>
        <button
          type="button"
          class="quiet"
          aria-label={`${letter || name}: ${reset.label}`}
          title={reset.label}
          disabled={reset.onReset === null}
          onClick={() => reset.onReset?.()}
        >
          <Icon name="undo" />
        </button>
      </NumberField>
    </div>
  );
}

function UnusedNote({ children }: { children: ComponentChildren }) {
  return <span class="unused-note"> · {children}</span>;
}

/** Decades from the first position to the last, where the scale begins with 0. */
const decadesFromZero = 4;

// All numbers span decades, so a slider's ticks are equal factors.
function toTick(value: number, { min, max }: Range): number {
  if (value <= min) return 0;
  const least = min || max * 10 ** -decadesFromZero;
  return Math.min(ticks, Math.max(1, Math.round((ticks * Math.log(value / least)) / Math.log(max / least))));
}

function fromTick(tick: number, { min, max }: Range): number {
  if (tick === 0) return min;
  const least = min || max * 10 ** -decadesFromZero;
  return least * (max / least) ** (tick / ticks);
}

/** Three significant digits: what a slider can mean. */
function round(value: number): number {
  return Number(value.toPrecision(3));
}
