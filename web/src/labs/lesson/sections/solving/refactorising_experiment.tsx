import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatNumber } from '../../../../lib/format.ts';
import { formatTime } from '../../../../lib/format_time.ts';
import type { RefactorisingTime } from '../../../../solver/time_solving.ts';
import { Failure } from '../../timing/failure.tsx';
import { useTimingWorker } from '../../timing/use_timing_worker.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** As many vertices, along a side, as a dense matrix still makes bearable. */
const side = 20;
const iterations = 50;

/** A time step's solves by the clock: Q factorised once and for all, and again in every iteration. */
export function RefactorisingExperiment() {
  const words = inLanguage({ en, zh }).refactorising;
  const { running, failure, run } = useTimingWorker();
  const [times, setTimes] = useState<Record<'dense' | 'sparse', RefactorisingTime> | null>(null);
  const start = async () => {
    setTimes(await run((service) => service.timeRefactorising(side, iterations)));
  };
  return (
    <div class="experiment">
      <button type="button" aria-disabled={running} onClick={() => !running && void start()}>
        {running ? words.running : words.start}
      </button>
      <Failure reason={failure} />
      <table class="numbers">
        <caption>{fillTemplate(words.caption, { n: side * side, iterations })}</caption>
        <thead>
          <tr>
            <td />
            <th scope="col">{words.once}</th>
            <th scope="col">{words.everyTime}</th>
            <th scope="col">{words.ratio}</th>
          </tr>
        </thead>
        <tbody>
          {(['dense', 'sparse'] as const).map((storage) => (
            <tr key={storage} data-storage={storage}>
              <th scope="row">{words[storage]}</th>
              {times ? <Times {...times[storage]} /> : <td colSpan={3}>–</td>}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Times({ once, everyTime }: RefactorisingTime) {
  return (
    <>
      <td>{formatTime(once)}</td>
      <td>{formatTime(everyTime)}</td>
      <td>{formatNumber(everyTime / once, 2)} ×</td>
    </>
  );
}
