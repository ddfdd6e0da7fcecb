import { useRef, useState } from 'preact/hooks';
import { type KinematicsSettings, reachOf } from '../../../app/kinematics.ts';
import { Choice } from '../../../lib/choice.tsx';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatFixed, formatLength, formatNumber } from '../../../lib/format.ts';
import { leastError, shellOf } from '../../../solver/ik_shell.ts';
import { type IkMethod, ikMethods } from '../../../solver/inverse_kinematics.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { questionWords } from './question_words.ts';
import { SideView } from './side_view.tsx';
import { Slider } from './slider.tsx';
import { angleBeside, type TargetPlace } from './target_place.ts';
import { UnreachableTable } from './unreachable_table.tsx';
import { type Experiments, useSeen } from './use_experiments.ts';
import { useReach } from './use_reach.ts';
import './unreachable.css';

const hundredths = (value: number) => Math.round(100 * value) / 100;

/** Of the reach: the farthest target. */
const beyondReach = 1.4;

/** A target that moves out of reach and back: found by asking for its distance first, and by searching alone. */
export function Unreachable({ experiments, settings }: { experiments: Experiments; settings: KinematicsSettings }) {
  const { unreachable: words, methods } = questionWords();
  const host = useRef<HTMLDivElement>(null);
  const seen = useSeen(host);
  const { root, iterations, epsilon } = settings;
  const others = settings.links.slice(0, -1);
  const [last, setLast] = useState(settings.links[others.length].length);
  const [wanted, place] = useState<TargetPlace>({ distance: hundredths(1.05 * reachOf(settings)), direction: 60 });
  const [method, setMethod] = useState<IkMethod>('ccd');

  const links = [...others, { length: last, bend: null }];
  const shell = shellOf(links.map(({ length }) => length));
  const most = hundredths(beyondReach * shell.farthest);
  const target = { ...wanted, distance: Math.min(wanted.distance, most) };
  const results = useReach(
    experiments,
    settings,
    seen ? { arm: { links, root, iterations, epsilon }, place: target } : null,
  );
  const shown = results?.find((result) => result.method === method) ?? null;
  const least = leastError(target.distance, shell);
  const where = least <= epsilon ? 'within' : target.distance > shell.farthest ? 'tooFar' : 'tooNear';
  const verdict = fillTemplate(words[where], { least: formatLength(least) });
  return (
    <div ref={host} class="question-stage" data-answered={results !== null}>
      <SideView
        root={root}
        shell={shell}
        most={most}
        place={target}
        onPlace={place}
        poses={shown && { tested: shown.tested.x, untested: shown.untested.x }}
      />
      <div class="question-controls">
        <Slider
          label={words.distance}
          {...{ value: target.distance, min: 0.05, max: most, step: 0.01 }}
          text={formatLength(target.distance)}
          spoken={`${formatLength(target.distance)}. ${verdict}`}
          onSet={(distance) => place({ ...target, distance })}
        />
        <Slider
          label={words.direction}
          {...{ value: target.direction, min: -180, max: 180, step: 1 }}
          text={`${formatFixed(target.direction, 0)}°`}
          onSet={(direction) => place({ ...target, direction })}
        />
        <Slider
          label={words.last}
          {...{ value: last, min: 0.1, max: 3, step: 0.1 }}
          text={formatLength(last)}
          onSet={setLast}
        />
        <p class="question-verdict" data-where={where}>
          {verdict}
        </p>
        {shown && (
          <p class="question-fact">
            {fillTemplate(words.beside, {
              target: formatNumber(angleBeside(target)),
              arm: formatNumber((shown.turned * 180) / Math.PI),
            })}
          </p>
        )}
        <Choice
          label={words.shown}
          options={ikMethods.map((one) => [one, methods[one]] as const)}
          chosen={method}
          onChoose={setMethod}
        />
        <p class="side-view-key">
          <span class="side-view-tested">{words.tested}</span> <span class="side-view-untested">{words.untested}</span>
        </p>
      </div>
      {results && (
        <>
          <LineChart
            series={results.map(({ method: one, beyond }) => ({
              name: methods[one],
              points: beyond.map((error, at) => [at + 1, error] as const),
            }))}
            x={{ label: words.iteration, range: [0, iterations] }}
            y={{ label: words.beyond, logarithmic: true, range: [1e-6, 10] }}
            summary={words.summary}
          />
          <p class="question-note">{words.jump}</p>
          <UnreachableTable results={results} />
        </>
      )}
    </div>
  );
}
