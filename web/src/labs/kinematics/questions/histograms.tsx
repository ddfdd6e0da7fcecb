import { fillTemplate } from '../../../lib/fill_template.ts';
import type { IterationCounts } from '../../../solver/ik_counts.ts';
import { ikOutcomes } from '../../../solver/inverse_kinematics.ts';
import { histogram, median } from './histogram.ts';
import { HistogramNumbers } from './histogram_numbers.tsx';
import { HistogramPicture } from './histogram_picture.tsx';
import { questionWords } from './question_words.ts';
import './histograms.css';

/** One histogram for every method and precision, all with the same axis of iterations. */
export function Histograms({ counts }: { counts: readonly IterationCounts[] }) {
  const { iterations: words, methods } = questionWords();
  const most = Math.max(...counts.flatMap(({ iterations }) => [...iterations]));
  const drawn = counts.map(({ method, precision, iterations, outcomes }) => ({
    name: fillTemplate(words.name, { method: methods[method], precision: words[precision] }),
    middle: median(iterations),
    most: Math.max(...iterations),
    bins: histogram(iterations, outcomes, most),
  }));
  const present = ikOutcomes.filter((outcome) => counts.some(({ outcomes }) => outcomes.includes(outcome)));
  return (
    <section aria-label={words.histograms}>
      <ul class="histogram-key">
        {present.map((outcome) => (
          <li key={outcome}>
            <svg width="14" height="14" aria-hidden="true">
              <rect class={`histogram-${outcome}`} width="14" height="14" rx="2" />
            </svg>
            <code>{outcome}</code> {words.outcomes[outcome]}
          </li>
        ))}
      </ul>
      <div class="histograms">
        {drawn.map(({ name, middle, most: largest, bins }) => (
          <HistogramPicture
            key={name}
            name={name}
            summary={fillTemplate(words.summary, { median: middle, most: largest })}
            bins={bins}
            axis={words.axis}
          />
        ))}
      </div>
      <HistogramNumbers drawn={drawn} />
    </section>
  );
}
