import { useState } from 'preact/hooks';
import { t } from '../../../app/messages/index.ts';
import type { Bin } from './histogram.ts';
import { questionWords } from './question_words.ts';

/** The histograms as a table; all of them have the same bins. */
export function HistogramNumbers({ drawn }: { drawn: readonly { name: string; bins: readonly Bin[] }[] }) {
  const words = questionWords().iterations;
  const [open, setOpen] = useState(false);
  return (
    <details class="line-chart-numbers" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{t('plots.numbers')}</summary>
      {open && (
        <table class="question-table">
          <caption>{words.targets}</caption>
          <thead>
            <tr>
              <th scope="col">{words.axis}</th>
              {drawn.map(({ name }) => (
                <th key={name} scope="col">
                  {name}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {drawn[0].bins.map(({ from, to }, at) => (
              <tr key={from}>
                <th scope="row">{from === to ? from : `${from}–${to}`}</th>
                {drawn.map(({ name, bins }) => (
                  <td key={name}>{bins[at].count}</td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </details>
  );
}
