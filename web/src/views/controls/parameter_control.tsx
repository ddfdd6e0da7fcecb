import type { Actions } from '../../app/actions.ts';
import { limits, type Scaled } from '../../app/limits.ts';
import { t } from '../../app/messages/index.ts';
import { parameters, state } from '../../app/state.ts';
import { Icon } from '../../lib/icon.tsx';
import type { SymbolId } from '../../notation/symbols.ts';
import { NumberField, showNumber } from './number_field.tsx';
import './controls.css';

interface Props {
  name: Scaled;
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
  const value = parameters.value[name];
  const { min, max } = limits[name];
  const id = `parameter-${name}`;
  const whole = name === 'iterations';
  const unused = name === 'w' && parameters.value.path === 'fast'; // its pins are held exactly
  const text = `${showNumber(value)} ${unit}`;

  return (
    <div class={unused ? 'parameter unused' : 'parameter'}>
      <label for={id}>
        <i class="symbol" data-sym={symbol ?? undefined}>
          {letter}
        </i>
        {t(`page.controls.${name}`)}
        {unused && <span class="unused-note"> · {t('page.controls.notInUse')}</span>}
      </label>
      <input
        type="range"
        min={0}
        max={ticks}
        value={toTick(value, min, max)}
        style={{ '--filled': `${(100 * toTick(value, min, max)) / ticks}%` }}
        aria-label={t(`page.controls.${name}`)}
        aria-valuetext={unused ? `${text}, ${t('page.controls.notInUse')}` : text}
        onInput={(event) => {
          const next = fromTick(event.currentTarget.valueAsNumber, min, max);
          actions.setParameter(name, whole ? Math.round(next) : round(next));
        }}
      />
      <NumberField
        id={id}
        value={value}
        min={min}
        max={max}
        whole={whole}
        unit={unit}
        onSet={(next) => actions.setParameter(name, next)}
      >
        <button
          type="button"
          class="quiet"
          aria-label={`${letter}: ${t('page.controls.reset')}`}
          title={t('page.controls.reset')}
          disabled={state.value.parameters[name] === undefined}
          onClick={() => actions.resetParameter(name)}
        >
          <Icon name="undo" />
        </button>
      </NumberField>
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
