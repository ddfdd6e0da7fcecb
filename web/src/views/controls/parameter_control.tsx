import { useState } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { limits } from '../../app/limits.ts';
import { t } from '../../app/messages/index.ts';
import { type Adjustable, parameters, state } from '../../app/state.ts';
import { Icon } from '../../lib/icon.tsx';
import { parseNumber } from '../../lib/parse_number.ts';
import type { SymbolId } from '../../notation/symbols.ts';

type Name = Exclude<keyof Adjustable, 'wind'>;

interface Props {
  name: Name;
  /** The letter, and its symbol in the equations, if it stands there: they share the colour. */
  letter: string;
  symbol: SymbolId | null;
  unit: string;
  actions: Actions;
}

/** Positions of the slider. */
const ticks = 1000;

/** One parameter: slider for the feel of it, field for the exact value, and the way back to the scene's own. */
export function ParameterControl({ name, letter, symbol, unit, actions }: Props) {
  const [problem, setProblem] = useState<string | null>(null);
  const value = parameters.value[name];
  const { min, max } = limits[name];
  const id = `parameter-${name}`;
  const changed = state.value.parameters[name] !== undefined;

  const whole = name === 'iterations';
  const set = (next: number) => {
    setProblem(null);
    actions.setParameter(name, next);
  };
  const read = (text: string) => {
    const number = parseNumber(text, unit);
    if (number === null) setProblem(t('page.controls.notANumber', { text }));
    else if (number < min || number > max)
      setProblem(t('page.controls.outOfRange', { value: text, min: show(min), max: show(max) }));
    else if (whole && !Number.isInteger(number)) setProblem(t('page.controls.notWhole', { value: text }));
    else set(number);
  };

  return (
    <div class="parameter">
      <label for={id}>
        <i class="symbol" data-sym={symbol ?? undefined}>
          {letter}
        </i>
        {t(`page.controls.${name}`)}
      </label>
      <input
        type="range"
        min={0}
        max={ticks}
        value={toTick(value, min, max)}
        style={{ '--filled': `${(100 * toTick(value, min, max)) / ticks}%` }}
        aria-label={t(`page.controls.${name}`)}
        aria-valuetext={`${show(value)} ${unit}`}
        onInput={(event) => {
          const next = fromTick(event.currentTarget.valueAsNumber, min, max);
          set(whole ? Math.round(next) : round(next));
        }}
      />
      <span class="parameter-value">
        <input
          id={id}
          inputMode="decimal"
          autocomplete="off"
          value={show(value)}
          aria-invalid={problem !== null}
          aria-describedby={problem ? `${id}-problem` : undefined}
          onChange={(event) => read(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === 'Enter') event.currentTarget.blur(); // and the page's own keys work again
          }}
        />
        <span class="unit">{unit}</span>
        <button
          type="button"
          class="quiet"
          aria-label={`${letter}: ${t('page.controls.reset')}`}
          title={t('page.controls.reset')}
          disabled={!changed}
          onClick={() => {
            setProblem(null);
            actions.resetParameter(name);
          }}
        >
          <Icon name="undo" />
        </button>
      </span>
      {problem && (
        <p class="parameter-problem" id={`${id}-problem`} role="alert">
          {problem}
        </p>
      )}
    </div>
  );
}

// All parameters span decades, so a slider's ticks are equal factors.
function toTick(value: number, min: number, max: number): number {
  return Math.round((ticks * Math.log(value / min)) / Math.log(max / min));
}

function fromTick(tick: number, min: number, max: number): number {
  return min * (max / min) ** (tick / ticks);
}

/** Three significant digits: what a slider can mean. */
function round(value: number): number {
  return Number(value.toPrecision(3));
}

/** Short and exact enough to be typed again: 1/30 stays 0.03333 on screen only. */
function show(value: number): string {
  return value >= 1e6 ? value.toExponential().replace('e+', 'e') : String(Number(value.toPrecision(4)));
}
