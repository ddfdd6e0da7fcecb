import { proxy } from 'comlink';
import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fitPowerLaw, type PowerLaw } from '../../../../lib/fit_power_law.ts';
import { type SolvingCall, type SolvingTime, solvingCalls } from '../../../../solver/time_solving.ts';
import { LineChart, type Series } from '../../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../../views/equations/prose.tsx';
import { Failure } from '../../timing/failure.tsx';
import { useTimingWorker } from '../../timing/use_timing_worker.ts';
import { en } from './en.ts';
import { ExponentTable } from './exponent_table.tsx';
import { zh } from './zh.ts';

/** Vertices along a side of the net: about twice the vertices each time. */
const sides = [5, 7, 10, 14, 20, 28, 40, 56, 80, 113];

/** Small nets show what a call costs at all, only larger ones how it grows. */
const fittedPoints = 4;

/** All ways to solve Q p = b on the reader's own machine, on larger and larger nets. */
export function TimingExperiment() {
  const words = inLanguage({ en, zh }).timing;
  const { running, failure, run, stop } = useTimingWorker();
  const [times, setTimes] = useState<readonly SolvingTime[]>([]);
  const [finished, setFinished] = useState(false);
  const laws = lawsOf(times);
  const done = new Set(times.map(({ n }) => n)).size;
  const start = async () => {
    setTimes([]);
    setFinished(false);
    const report = proxy((time: SolvingTime) => setTimes((before) => [...before, time]));
    setFinished((await run((service) => service.timeSolving(sides, report).then(() => true))) ?? false);
  };
  return (
    <figure class="figure timing" data-ready data-running={running}>
      <div class="experiment-controls">
        <button type="button" onClick={running ? stop : () => void start()}>
          {running ? words.stop : times.length > 0 ? words.again : words.start}
        </button>
        <progress max={sides.length} value={done} aria-label={words.progress} />
        <span role="status">{finished && words.finished}</span>
      </div>
      <Failure reason={failure} />
      <LineChart
        series={solvingCalls.map((call) =>
          seriesOf(
            words.calls[call],
            times.filter((time) => time.call === call),
            laws[call],
          ),
        )}
        x={{ label: <Phrase text={words.axes.n} />, logarithmic: true, range: [10, 20_000] }}
        y={{ label: <Phrase text={words.axes.time} />, logarithmic: true, range: [1e-4, 1e4] }}
        summary={words.plot}
      />
      <ExponentTable laws={laws} />
      <figcaption>{words.caption}</figcaption>
    </figure>
  );
}

function lawsOf(times: readonly SolvingTime[]): Partial<Record<SolvingCall, PowerLaw>> {
  const laws: Partial<Record<SolvingCall, PowerLaw>> = {};
  for (const call of solvingCalls) {
    const law = fitPowerLaw(pointsOf(times.filter((time) => time.call === call)).slice(-fittedPoints));
    if (law) laws[call] = law;
  }
  return laws;
}

function seriesOf(name: string, times: readonly SolvingTime[], law: PowerLaw | undefined): Series {
  const series = { name, points: pointsOf(times), dots: true };
  if (!law) return series;
  return { ...series, law: law.points.map(([n]): [number, number] => [n, law.factor * n ** law.exponent]) };
}

function pointsOf(times: readonly SolvingTime[]): [n: number, milliseconds: number][] {
  return times.map(({ n, milliseconds }) => [n, milliseconds]);
}
