import { useEffect, useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatFixed } from '../../../../lib/format.ts';
import { LineChart } from '../../../../views/charts/line_chart.tsx';
import { Phrase, Prose } from '../../../../views/equations/prose.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { SideBySide } from '../../figures/side_by_side.tsx';
import { useEnergies } from '../../figures/use_energies.ts';
import { useFigures } from '../../figures/use_figures.ts';
import { en } from './en.ts';
import { steps } from './steps.ts';
import { zh } from './zh.ts';

const settings = steps.map(
  ({ delta_t }): FigureSettings => ({
    scene: 'triangle',
    parameters: { delta_t },
    selection: { spring: null, vertex: null },
  }),
);

/** s: how long they run. */
const duration = 5;

/** One net by four lengths of the time step, in real time. */
export function FourSteps() {
  const words = inLanguage({ en, zh }).size;
  const figures = useFigures(settings);
  const energies = useEnergies(figures);
  const names = steps.map(({ name }) => fillTemplate(words.name, { delta_t: name }));
  const ended = energies.map((curve) => (curve.at(-1)?.[0] ?? 0) >= duration - 1e-9);
  const [wanted, setWanted] = useState(false);
  const over = ended.every(Boolean);
  const running = wanted && !over;

  useEffect(() => {
    for (const [at, figure] of figures.entries()) figure.playing.value = wanted && !ended[at];
  });

  const rewind = () => {
    for (const figure of figures) figure.reset();
  };
  const toggle = () => {
    if (over) rewind();
    setWanted(!running);
  };
  const reset = () => {
    rewind();
    setWanted(false);
  };

  return (
    <>
      <SideBySide
        figures={figures}
        names={names}
        readings={energies.map((curve) => {
          const [time, gained] = curve.at(-1) ?? [0, 0];
          return fillTemplate(words.reading, {
            time: `${formatFixed(time, 1)} s`,
            gained: `${formatFixed(gained, 2)} J`,
          });
        })}
        running={running}
        onToggle={toggle}
        onReset={reset}
      >
        <LineChart
          series={energies.map((points, at) => ({ name: names[at], points }))}
          x={{ label: <Phrase text={words.time} />, range: [0, duration] }}
          y={{ label: <Phrase text={words.energy} />, range: [-4, 0] }}
          summary={words.summary}
        />
      </SideBySide>
      <Prose text={words.seen} />
    </>
  );
}
