import { useCallback } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { state } from '../../app/state.ts';
import type { Frame } from '../../solver/frame.ts';
import { ComparisonChart } from './comparison_chart.tsx';
import { ObjectiveChart } from './objective_chart.tsx';
import 'uplot/dist/uPlot.min.css';
import '../../notation/colours.css';
import { Choice } from '../../lib/choice.tsx';
import './plots.css';

/** One time step in a plot: half-step by half-step, or by every method. */
export function Plots({ frame, actions }: { frame: Frame; actions: Actions }) {
  const { plot } = state.value.view;
  const seek = useCallback((half_step: number) => actions.seek(half_step), [actions]);
  return (
    <figure class="objective">
      <figcaption>
        {t(`plots.title.${plot}`)}
        <Choice
          label={t('plots.choice')}
          options={[
            ['trace', t('plots.trace')],
            ['comparison', t('plots.byMethods')],
          ]}
          chosen={plot}
          onChoose={(chosen) => actions.setView({ plot: chosen })}
        />
      </figcaption>
      {plot === 'trace' ? <ObjectiveChart frame={frame} onSeek={seek} /> : <ComparisonChart actions={actions} />}
    </figure>
  );
}
