import type { Actions } from '../../app/actions.ts';
import { limits, type Scaled } from '../../app/limits.ts';
import { t } from '../../app/messages/index.ts';
import { parameters, state } from '../../app/state.ts';
import type { SymbolId } from '../../notation/symbols.ts';
import { ScaledControl } from './scaled_control.tsx';

interface Props {
  name: Scaled;
  /** The letter, and its symbol in the equations, if it stands there: they share the colour. */
  letter: string;
  symbol: SymbolId | null;
  unit: string;
  actions: Actions;
}

/** One parameter of the springs lab. */
export function ParameterControl({ name, letter, symbol, unit, actions }: Props) {
  const unused = name === 'w' && parameters.value.path === 'fast'; // its pins are held exactly
  const changed = state.value.parameters[name] !== undefined;
  return (
    <ScaledControl
      id={`parameter-${name}`}
      letter={letter}
      symbol={symbol}
      name={t(`page.controls.${name}`)}
      unit={unit}
      value={parameters.value[name]}
      limits={limits[name]}
      whole={name === 'iterations'}
      unused={unused ? t('page.controls.notInUse') : undefined}
      onSet={(next) => actions.setParameter(name, next)}
      reset={{
        label: t('page.controls.reset'),
        onReset: changed ? () => actions.resetParameter(name) : null,
      }}
    />
  );
}
