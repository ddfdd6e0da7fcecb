import { useEffect, useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatNumber, formatQuantity } from '../../../../lib/format.ts';
import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import type { FigureSession, FigureSettings } from '../../figures/figure_session.ts';
import { FigureSlider } from '../../figures/figure_slider.tsx';
import { SideBySide } from '../../figures/side_by_side.tsx';
import { type EnergyCurve, useEnergies } from '../../figures/use_energies.ts';
import { useFigures } from '../../figures/use_figures.ts';
import { en } from './en.ts';
import { free } from './landscape_grid.ts';
import { angularFrequency, exploded } from './stability.ts';
import { useLeaving } from './use_leaving.ts';
import { useRun } from './use_run.ts';
import { zh } from './zh.ts';

/** Just too stiff for its time step. */
const stiff: FigureSettings = {
  scene: 'single-spring-horizontal',
  parameters: { k: 2000, delta_t: 0.05 },
  selection: { spring: null, vertex: null },
};
const settings = [stiff, stiff];

/** s: what the plot has room for. */
const duration = 6;

/** One spring twice: pulled by the forces at p^t, and by those at p^{t+Δt}. */
export function ExplicitForces() {
  const words = inLanguage({ en, zh }).explicit;
  const figures = useFigures(settings);
  const [explicit, implicit] = figures;
  const energies = useEnergies(figures);
  const [wanted, setWanted] = useState(false);
  const [time, gained] = last(energies[0]);
  const over = time >= duration || gained > exploded;
  const running = wanted && !over;
  useRun(running, explicit, implicit);
  const leavings = [useLeaving(explicit, free), useLeaving(implicit, free)];

  const restart = () => {
    for (const figure of figures) figure.order({ kind: 'reset' });
  };
  const { value: chosen } = explicit.chosen;
  useEffect(() => {
    implicit.chosen.value = chosen;
    restart();
  }, [chosen]);

  const toggle = () => {
    if (over) restart();
    setWanted(!running);
  };
  const reset = () => {
    setWanted(false);
    for (const figure of figures) figure.reset();
  };

  return (
    <SideBySide
      figures={figures}
      names={[words.atStart, words.atEnd]}
      readings={energies.map((curve, at) => {
        const left = leavings[at];
        const reading = fillTemplate(words.reading, {
          time: formatQuantity(last(curve)[0], 's'),
          gained: formatQuantity(last(curve)[1], 'J'),
        });
        const leaving = left === null ? '\u00a0' : fillTemplate(words.left, { time: formatQuantity(left, 's') });
        return `${reading}\n${leaving}`;
      })}
      running={running}
      onToggle={toggle}
      onReset={reset}
    >
      <div class="figure-sliders">
        <FigureSlider figure={explicit} name="k" />
        <FigureSlider figure={explicit} name="delta_t" />
      </div>
      {explicit.frame.value && <Verdict figure={explicit} />}
      <LineChart
        series={energies.map((points, at) => ({ name: [words.atStart, words.atEnd][at], points }))}
        x={{ label: <Phrase text={words.time} />, range: [0, duration] }}
        y={{ label: <Phrase text={words.energy} />, range: [-20, 100] }}
        summary={words.summary}
      />
    </SideBySide>
  );
}

/** On which side of the limit the chosen k and Δt are. */
function Verdict({ figure }: { figure: FigureSession }) {
  const words = inLanguage({ en, zh }).explicit;
  const { k, delta_t, mass_scale } = figure.parameters.value;
  const omega = angularFrequency(k, mass_scale * figure.scene.value.m[free]);
  const stable = delta_t * omega < 2;
  return (
    <p class={stable ? 'verdict' : 'verdict verdict-unstable'} aria-live="polite">
      <Phrase
        text={fillTemplate(stable ? words.stable : words.unstable, {
          omega: formatNumber(omega),
          product: formatNumber(delta_t * omega),
        })}
      />
    </p>
  );
}

function last(curve: EnergyCurve): readonly [time: number, gained: number] {
  return curve.at(-1) ?? [0, 0];
}
