import { useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import type { MethodRun } from '../../solver/protocol.ts';
import { comparisonCsv } from './comparison_csv.ts';
import { type Curve, type Ordinate, shownIterations } from './comparison_curves.ts';
import { heightText, heightUnit } from './comparison_readout.tsx';
import { downloadText } from './download.ts';

interface Props {
  step: number;
  caption: string;
  curves: readonly Curve[];
  ordinate: Ordinate;
  runs: readonly MethodRun[];
}

/** Every number of the plot as text, folded away until wanted. */
export function ComparisonTable({ step, caption, curves, ordinate, runs }: Props) {
  const [open, setOpen] = useState(false);
  const download = () => downloadText(`methods-step-${step}.csv`, 'text/csv', comparisonCsv(runs));
  return (
    <details class="trace-table" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{t('plots.comparison.data')}</summary>
      <button type="button" onClick={download}>
        {t('plots.download')}
      </button>
      {open && <Rows caption={caption} curves={curves} ordinate={ordinate} />}
    </details>
  );
}

function Rows({ caption, curves, ordinate }: Pick<Props, 'caption' | 'curves' | 'ordinate'>) {
  const longest = Math.max(...curves.map(({ last }) => last));
  const iterations = Array.from({ length: Math.min(longest, shownIterations) + 1 }, (_, k) => k);
  return (
    <div class="trace-table-scroll">
      <table>
        <caption>
          {heightUnit(ordinate)}. {caption}
        </caption>
        <thead>
          <tr>
            <th scope="col">{t('plots.comparison.iterations')}</th>
            {curves.map(({ method }) => (
              <th key={method} scope="col">
                {t(`methods.name.${method}`)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {iterations.map((k) => (
            <tr key={k}>
              <th scope="row">{k}</th>
              {curves.map(({ method, points, last }) => (
                <td key={method}>{k <= last ? heightText(points[k], ordinate) : ''}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
