import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { findScene } from '../../../../app/scene_library.ts';
import { parametersOn, pinsOn } from '../../../../app/state.ts';
import { formatTime } from '../../../../lib/format_time.ts';
import type { Parameters } from '../../../../solver/module.ts';
import type { SceneTime } from '../../../../solver/time_scene.ts';
import { Failure } from '../../timing/failure.tsx';
import { useTimingWorker } from '../../timing/use_timing_worker.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

const storages = ['sparse', 'dense'] as const satisfies readonly Parameters['storage'][];
type Times = Partial<Record<(typeof storages)[number], SceneTime>>;

/** One time step of the flag on the plain path, its zeros left out and its zeros stored. */
export function FlagExperiment() {
  const words = inLanguage({ en, zh }).flag;
  const { running, failure, run, stop } = useTimingWorker();
  const [times, setTimes] = useState<Times>({});
  const [refused, setRefused] = useState(false);
  const start = async () => {
    setTimes({});
    setRefused(false);
    await run(async (service) => {
      const scene = await findScene('flag');
      for (const storage of storages) {
        const parameters: Parameters = { ...parametersOn(scene, {}), path: 'plain', storage };
        const outcome = await service.timeScene(scene, pinsOn(scene, null), parameters);
        if (!outcome.ok) return setRefused(true);
        setTimes((before) => ({ ...before, [storage]: outcome.value }));
      }
    });
  };
  return (
    <div class="experiment">
      <button type="button" onClick={() => (running ? stop() : void start())}>
        {running ? words.stop : words.start}
      </button>
      <Failure reason={failure} />
      {refused && (
        <p class="figure-refusal" role="alert">
          {words.tooLarge}
        </p>
      )}
      <table class="numbers" aria-busy={running}>
        <caption>{words.caption}</caption>
        <thead>
          <tr>
            <td />
            <th scope="col">{words.precomputation}</th>
            <th scope="col">{words.step}</th>
          </tr>
        </thead>
        <tbody>
          {storages.map((storage) => (
            <tr key={storage} data-storage={storage}>
              <th scope="row">{words[storage]}</th>
              <td>{shown(times[storage]?.precomputation)}</td>
              <td>{shown(times[storage]?.step)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function shown(milliseconds: number | undefined): string {
  return milliseconds === undefined ? '–' : formatTime(milliseconds);
}
