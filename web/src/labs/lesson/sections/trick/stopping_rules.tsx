import { t } from '../../../../app/messages/index.ts';
import type { StoppingRule } from '../../../../app/state.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatNumber, formatQuantity } from '../../../../lib/format.ts';
import { ObjectiveChart } from '../../../../views/plots/objective_chart.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession, FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { Phrase } from '../../prose.tsx';
import type { en } from './en.ts';

const settings: FigureSettings = {
  scene: 'patch',
  parameters: { k: 2000, iterations: 50 },
  opening: [{ kind: 'play', steps: 6 }, { kind: 'next_half_step' }],
};

/** N, and dimensionless. */
const tolerances: Record<StoppingRule, number> = { stop_gradient: 0.1, stop_decrease: 1e-4 };

const choices = ['never', 'stop_gradient', 'stop_decrease'] as const;

/** The objective over the half-steps of one time step, which ends by the rule that the reader chooses. */
export function StoppingRules({ words }: { words: typeof en.stop }) {
  const figure = useFigure(settings);
  const frame = figure.frame.value;
  const tolerance = {
    gradient: formatQuantity(tolerances.stop_gradient, 'N', 1),
    decrease: formatNumber(tolerances.stop_decrease, 1),
  };
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k', 'delta_t']} caption={words.caption}>
      <Rule figure={figure} />
      <p class="figure-note">
        <Phrase text={fillTemplate(words.tolerance, tolerance)} />
      </p>
      <div class="objective-place">
        {frame && <ObjectiveChart frame={frame} onSeek={(half_step) => figure.order({ kind: 'seek', half_step })} />}
      </div>
    </Figure>
  );
}

function Rule({ figure }: { figure: FigureSession }) {
  const { chosen } = figure;
  const inForce = choices.find((name) => name !== 'never' && chosen.value[name]) ?? 'never';
  const choose = (name: (typeof choices)[number]) => {
    const none = { ...chosen.value, stop_gradient: 0, stop_decrease: 0 };
    chosen.value = name === 'never' ? none : { ...none, [name]: tolerances[name] };
  };
  return (
    <fieldset class="stopping-rules">
      <legend>{t('methods.stop.label')}</legend>
      {choices.map((name) => (
        <label key={name}>
          <input type="radio" name="stopping-rule" checked={name === inForce} onChange={() => choose(name)} />
          {t(`methods.stop.${name}`)}
        </label>
      ))}
    </fieldset>
  );
}
