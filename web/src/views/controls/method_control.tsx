import type { Actions } from '../../app/actions.ts';
import { firstTolerance, limits } from '../../app/limits.ts';
import { t } from '../../app/messages/index.ts';
import { parameters, type StoppingRule } from '../../app/state.ts';
import { type Minimiser, minimisers } from '../../solver/module.ts';
import { NumberField } from './number_field.tsx';
import './controls.css';

/** What the tolerance ε of a rule is measured in. */
const units: Record<StoppingRule, string> = { stop_gradient: 'N', stop_decrease: '' };

/** How p gets from one iterate to the next, and what ends a time step before its K-th. */
export function MethodControl({ actions }: { actions: Actions }) {
  const { method } = parameters.value;
  return (
    <>
      <div class="method">
        <label for="method">{t('methods.label')}</label>
        <select
          id="method"
          value={method}
          aria-describedby="method-explained"
          onChange={(event) => actions.setParameter('method', event.currentTarget.value as Minimiser)}
        >
          {minimisers.map((name) => (
            <option key={name} value={name}>
              {t(`methods.name.${name}`)}
            </option>
          ))}
        </select>
      </div>
      <p class="method-explained" id="method-explained">
        {t(`methods.explained.${method}`)}
      </p>
      <StoppingControl actions={actions} />
    </>
  );
}

function StoppingControl({ actions }: { actions: Actions }) {
  const { stop_gradient, stop_decrease } = parameters.value;
  const rule = stop_gradient > 0 ? 'stop_gradient' : stop_decrease > 0 ? 'stop_decrease' : null;
  return (
    <div class="method">
      <label for="stopping">{t('methods.stop.label')}</label>
      <select
        id="stopping"
        value={rule ?? ''}
        onChange={(event) => {
          const chosen = (event.currentTarget.value || null) as StoppingRule | null;
          actions.setStoppingRule(chosen, chosen ? firstTolerance[chosen] : 0);
        }}
      >
        <option value="">{t('methods.stop.never')}</option>
        <option value="stop_gradient">{t('methods.stop.stop_gradient')}</option>
        <option value="stop_decrease">{t('methods.stop.stop_decrease')}</option>
      </select>
      {rule && (
        <span class="tolerance">
          <label for="tolerance">{t('methods.stop.tolerance')}</label>
          <NumberField
            id="tolerance"
            value={parameters.value[rule]}
            {...limits[rule]}
            unit={units[rule]}
            onSet={(epsilon) => actions.setStoppingRule(rule, epsilon)}
          />
        </span>
      )}
    </div>
  );
}
