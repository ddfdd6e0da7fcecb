import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../views/equations/prose.tsx';
import { angleFromBoth, angleFromCosine, angleTurned, leastKnown } from './float_angle.ts';
import { questionWords } from './question_words.ts';

/** rad. */
const range = [1e-5, 1e-2] as const;
const samplesOfDecade = 60;
const angles = Array.from({ length: 3 * samplesOfDecade + 1 }, (_, at) => range[0] * 10 ** (at / samplesOfDecade));
const unknown = leastKnown(angleTurned);

interface Props {
  /** m. */
  epsilon: number;
  /** m: of the links. */
  lengths: readonly number[];
}

/** What a float's cosine knows of small angles, and which angle an arm of these lengths has to turn by to come as near as ε. */
export function AngleFigure({ epsilon, lengths }: Props) {
  const words = questionWords().angle;
  const reach = lengths.reduce((sum, length) => sum + length, 0);
  const needed = { root: epsilon / reach, last: epsilon / lengths[lengths.length - 1] };
  const series = [
    [words.both, angleFromBoth],
    [words.cosine, angleFromCosine],
    [words.turned, angleTurned],
  ] as const;
  return (
    <section aria-labelledby="angle-heading">
      <h5 id="angle-heading">{words.heading}</h5>
      <p>
        <Phrase text={words.text} />
      </p>
      <LineChart
        series={series.map(([name, angle]) => ({
          name,
          points: angles.map((theta) => [theta, angle(theta)] as const),
        }))}
        x={{ label: <Phrase text={words.theta} />, logarithmic: true, range }}
        y={{ label: words.computed, logarithmic: true, range }}
        cursor={needed.root}
        summary={words.summary}
      />
      <p class="question-fact" data-enough={needed.root > unknown}>
        <Phrase
          text={fillTemplate(needed.root > unknown ? words.enough : words.tooSmall, {
            root: formatNumber(needed.root, 2),
            last: formatNumber(needed.last, 2),
            unknown: formatNumber(unknown, 2),
          })}
        />
      </p>
    </section>
  );
}
