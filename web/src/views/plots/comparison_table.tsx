import { useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import type { MethodRun } from '../../solver/protocol.ts';
import { comparisonCsv } from './comparison_csv.ts';
import { type Curve, shownIterations } from './comparison_curves.ts';
import { gapText } from './comparison_readout.tsx';
import { downloadText } from './download.ts';

interface Props {
  step: number;
  caption: string;
  curves: readonly Curve[];
  runs: readonly MethodRun[];
}

/** Every number of the plot as text, folded away until wanted. */
export function ComparisonTable({ step, caption, curves, runs }: Props) {
  const [open, setOpen] = useState(false);
  const download = () => downloadText(`methods-step-${step}.csv`, 'text/csv', comparisonCsv(runs));
  return (
    <details class="trace-table" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{t('plots.comparison.data')}</summary>
      <button type="button" onClick={download}>
        {t('plots.download')}
      </button>
      {open && <Rows caption={caption} curves={curves} />}
    </details>
  );
}

function Rows({ caption, curves }: Pick<Props, 'caption' | 'curves'>) {
  const longest = Math.max(...curves.map(({ points }) => points.length - 1));
  const iterations = Array.from({ length: Math.min(longest, shownIterations) + 1 }, (_, k) => k);
  return (
    <div class="trace-table-scroll">
      <table>
        <caption>{caption}</caption>
        <thead>
          <tr>
            <th scope="col">{t('plots.comparison.iterations')}</th>
            {curves.map(({ method }) => (
              <th key={method} scope="col">
                {t(`methods.name.${method}`)}, J
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {iterations.map((k) => (
            <tr key={k}>
              <th scope="row">{k}</th>
              {curves.map(({ method, points }) => (
                <td key={method}>{points[k] ? gapText(points[k].gap) : ''}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
