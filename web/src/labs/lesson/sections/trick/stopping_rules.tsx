import { t } from '../../../../app/messages/index.ts';
import type { StoppingRule } from '../../../../app/state.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatNumber, formatQuantity } from '../../../../lib/format.ts';
import type { Frame } from '../../../../solver/frame.ts';
import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession, FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import type { en } from './en.ts';

const settings = {
  scene: 'patch',
  parameters: { k: 2000, iterations: 50 },
  opening: [{ kind: 'play', steps: 6 }, { kind: 'next_half_step' }],
} as const satisfies FigureSettings;

/** N, and dimensionless. */
const tolerances: Record<StoppingRule, number> = { stop_gradient: 0.1, stop_decrease: 1e-4 };

const choices = ['never', 'stop_gradient', 'stop_decrease'] as const;

/** What is left unbalanced after each round of one time step, which ends by the rule that the reader chooses. */
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
      <LineChart
        series={[{ name: words.curve, points: forcesLeft(frame) }]}
        x={{ label: <Phrase text={words.rounds} />, range: [0, settings.parameters.iterations] }}
        y={{ label: <Phrase text={words.force} />, logarithmic: true, range: [1e-3, 1e2] }}
        cursor={frame?.iteration ?? 0}
        summary={words.summary}
      />
    </Figure>
  );
}

/** N, after every round of the time step; while the clock runs nobody knows. */
function forcesLeft(frame: Frame | null): [number, number][] {
  const ends = frame?.events.filter(({ phase }) => phase === 'predict' || phase === 'global') ?? [];
  return ends.map(({ iteration, gradient }) => [iteration, gradient]);
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
