import { useRef, useState } from 'preact/hooks';
import type { KinematicsSettings } from '../../../app/kinematics.ts';
import { formatNumber } from '../../../lib/format.ts';
import { steps125 } from '../../../lib/steps_125.ts';
import { CurveChoice } from './curve_choice.tsx';
import { JitterCharts } from './jitter_charts.tsx';
import { JitterTable } from './jitter_table.tsx';
import { boxAround } from './oblique.ts';
import { OnionSkin } from './onion_skin.tsx';
import { questionTargets } from './question_targets.ts';
import { questionWords } from './question_words.ts';
import { Slider } from './slider.tsx';
import { type Experiments, useSeen } from './use_experiments.ts';
import { type SweepName, sweepNames, useSweeps } from './use_sweeps.ts';
import './jitter.css';

const sides = ['first', 'second'] as const;

interface Props {
  experiments: Experiments;
  settings: KinematicsSettings;
  /** #T×3, m; null while the arm draws nothing. */
  drawn: Float64Array | null;
}

/** Degrees. */
const limits = steps125(0.1, 50);

/** One curve, followed in four ways; two of them are looked at side by side. */
export function Jitter({ experiments, settings, drawn }: Props) {
  const words = questionWords().jitter;
  const host = useRef<HTMLDivElement>(null);
  const seen = useSeen(host);
  const [wanted, setWanted] = useState<'circle' | 'heart' | 'drawn'>('heart');
  const [count, setCount] = useState(60);
  const [limit, setLimit] = useState(2);
  const [chosen, choose] = useState<readonly [SweepName, SweepName]>(['warm', 'random']);
  const [at, setAt] = useState(20);
  const curve = wanted === 'drawn' && !drawn ? 'heart' : wanted;
  const targets = drawn && curve === 'drawn' ? drawn : questionTargets(curve === 'circle' ? 'circle' : 'heart', count);
  const followed = useSweeps(experiments, settings, seen ? { targets, limit } : null);
  const last = (followed?.targets ?? targets).length / 3;
  const place = Math.min(at, last - 1);
  const box = followed && boxAround(chosen.map((name) => followed.sweeps[name].x));

  return (
    <div ref={host} data-answered={followed !== null}>
      <div class="question-row">
        <CurveChoice
          curves={drawn ? ['circle', 'heart', 'drawn'] : ['circle', 'heart']}
          chosen={curve}
          onChoose={setWanted}
        />
        {curve !== 'drawn' && (
          <Slider
            label={words.count}
            {...{ value: count, min: 20, max: 200, step: 20 }}
            text={String(count)}
            onSet={setCount}
          />
        )}
        <Slider
          label={words.limit}
          {...{ value: limits.indexOf(limit), min: 0, max: limits.length - 1, step: 1 }}
          text={`${formatNumber(limit, 1)}°`}
          onSet={(tick) => setLimit(limits[tick])}
        />
        <Slider
          label={words.place}
          {...{ value: place + 1, min: 1, max: last, step: 1 }}
          text={String(place + 1)}
          onSet={(next) => setAt(next - 1)}
        />
      </div>
      <div class="onion-skins">
        {([0, 1] as const).map((side) => (
          <section key={side} class={`curve-${side}`} aria-label={words.names[chosen[side]]}>
            <label>
              <span class="visually-hidden">{words.sides[sides[side]]}</span>
              <select
                value={chosen[side]}
                onChange={(event) => {
                  const name = event.currentTarget.value as SweepName;
                  choose(side === 0 ? [name, chosen[1]] : [chosen[0], name]);
                }}
              >
                {sweepNames.map((name) => (
                  <option key={name} value={name} disabled={name === chosen[1 - side]}>
                    {words.names[name]}
                  </option>
                ))}
              </select>
            </label>
            {followed && box && (
              <OnionSkin sweep={followed.sweeps[chosen[side]]} targets={followed.targets} at={place} box={box} />
            )}
          </section>
        ))}
      </div>
      {followed && <JitterCharts sweeps={followed.sweeps} chosen={chosen} at={place} />}
      {followed && <JitterTable sweeps={followed.sweeps} />}
    </div>
  );
}
