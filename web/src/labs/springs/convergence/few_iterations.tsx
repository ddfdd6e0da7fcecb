import { useEffect, useMemo } from 'preact/hooks';
import { labMoment } from '../../../app/lab_moment.ts';
import { type MessageKey, t } from '../../../app/messages/index.ts';
import { refusalParams } from '../../../app/refusal_params.ts';
import { SideBySide } from '../../../app/side_by_side.ts';
import type { EnergySample } from '../../../app/side_by_side_record.ts';
import { parameters, pins, scene } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatQuantity } from '../../../lib/format.ts';
import type { Variant, VariantState } from '../../../solver/side_by_side.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { Phrase, Prose } from '../../../views/equations/prose.tsx';
import { Nets } from '../../../views/scene3d/nets.tsx';
import type { en } from './en.ts';

type Words = typeof en.damped;

const counts = [1, 10, 50];

/** Time steps that the chart shows: the latest. */
const shownSteps = 300;

/** The lab's simulation going on from its present moment with few and with many iterations a time step, on one clock and under one drag. */
export function FewIterations({ words }: { words: Words }) {
  const run = useMemo(() => new SideBySide(), []);
  useEffect(() => run.follow(), [run]);
  const states = run.states.value;
  const start = async () => {
    run.playing.value = false;
    const common = { scene: scene.value, pins: pins.value, from: labMoment() };
    if (await run.open(variantsOf(), common)) run.playing.value = true;
  };
  return (
    <section class="convergence-damped">
      <h3>{words.title}</h3>
      <Prose text={words.text} />
      <button type="button" onClick={start}>
        {states ? words.again : words.start}
      </button>
      {states && (
        <>
          <Nets
            run={run}
            captions={counts.map((iterations, at) => ({
              name: fillTemplate(words.count, { iterations }),
              note: noteOf(words, states[at], run.energies.value[at]),
            }))}
          />
          <Energies words={words} energies={run.energies.value} />
        </>
      )}
    </section>
  );
}

function variantsOf(): Variant[] {
  const common = { ...parameters.value, method: 'local-global', stop_gradient: 0, stop_decrease: 0 } as const;
  return counts.map((iterations) => ({ parameters: { ...common, iterations }, substeps: 1, mistake: 'none' }));
}

function noteOf(words: Words, { failure }: VariantState, energies: readonly EnergySample[]): string {
  if (failure) return t(`page.errors.${failure.status.code}` as MessageKey, refusalParams(failure.status));
  const latest = energies.at(-1);
  return latest ? fillTemplate(words.note, { kinetic: formatQuantity(latest.kinetic, 'J', 2) }) : '';
}

interface EnergiesProps {
  words: Words;
  energies: SideBySide['energies']['value'];
}

/** The total energy of each over time. */
function Energies({ words, energies }: EnergiesProps) {
  const series = counts.map((iterations, at) => ({
    name: fillTemplate(words.count, { iterations }),
    points: (energies[at] ?? [])
      .slice(-shownSteps)
      .map(({ time, kinetic, springs, external }) => [time, kinetic + springs + external] as const),
  }));
  if (series[0].points.length < 2) return null;
  return (
    <LineChart
      series={series}
      x={{ label: <Phrase text={words.time} /> }}
      y={{ label: <Phrase text={words.energy} /> }}
      summary={words.summary}
    />
  );
}
