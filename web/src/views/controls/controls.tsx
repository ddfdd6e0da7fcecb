import type { Actions } from '../../app/actions.ts';
import { exaggerations } from '../../app/limits.ts';
import { t } from '../../app/messages/index.ts';
import { parameters, scene, state } from '../../app/state.ts';
import { MethodControl } from './method_control.tsx';
import { ParameterControl } from './parameter_control.tsx';
import './controls.css';

/** What is simulated, with which numbers, and how it is drawn. */
export function Controls({ actions }: { actions: Actions }) {
  const { parameters: changed, pins, view } = state.value;
  return (
    <section class="controls" aria-labelledby="controls-heading">
      <h2 id="controls-heading">{t('page.controls.heading')}</h2>
      <ParameterControl name="k" letter="k" symbol="k" unit="N/m" actions={actions} />
      <ParameterControl name="delta_t" letter="Δt" symbol="deltaT" unit="s" actions={actions} />
      <ParameterControl name="mass_scale" letter="m" symbol="m" unit="×" actions={actions} />
      <ParameterControl name="w" letter="w" symbol="w" unit="N/m" actions={actions} />
      <ParameterControl name="iterations" letter="K" symbol={null} unit="" actions={actions} />
      <MethodControl actions={actions} />

      <div class="controls-switches">
        <label title={t('page.controls.windHint')}>
          <input
            type="checkbox"
            checked={parameters.value.wind}
            onChange={(event) => actions.setParameter('wind', event.currentTarget.checked)}
          />
          {t('page.controls.wind')}
        </label>
        <label>
          <input
            type="checkbox"
            checked={view.springs}
            onChange={(event) => actions.setView({ springs: event.currentTarget.checked })}
          />
          {t('page.controls.springs')}
        </label>
        {scene.value.F.length > 0 && (
          <label>
            <input
              type="checkbox"
              checked={view.surface}
              onChange={(event) => actions.setView({ surface: event.currentTarget.checked })}
            />
            {t('page.controls.surface')}
          </label>
        )}
        <label>
          {t('page.controls.exaggeration')}{' '}
          <select
            value={String(view.exaggeration)}
            onChange={(event) => {
              const { value } = event.currentTarget;
              actions.setView({ exaggeration: value === 'automatic' ? value : Number(value) });
            }}
          >
            <option value="automatic">{t('page.controls.automatic')}</option>
            {exaggerations.map((factor) => (
              <option key={factor} value={String(factor)}>
                ×{factor}
              </option>
            ))}
          </select>
        </label>
      </div>
      <div class="controls-resets">
        <button type="button" disabled={Object.keys(changed).length === 0} onClick={() => actions.resetParameters()}>
          {t('page.controls.resetAll')}
        </button>
        <button type="button" disabled={pins === null} onClick={() => actions.resetPins()}>
          {t('page.controls.resetPins')}
        </button>
      </div>
    </section>
  );
}
