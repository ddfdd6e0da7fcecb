import { useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { formatNumber } from '../../lib/format.ts';
import type { TraceEvent } from '../../solver/frame.ts';
import { downloadText } from './download.ts';
import { traceCsv } from './trace_csv.ts';

/** The columns that are measured; half-step and phase stand before them. */
const quantities = [
  ['surrogate', 'J'],
  ['objective', 'J'],
  ['potential', 'J'],
  ['inertia', 'J'],
  ['external', 'J'],
  ['pin', 'J'],
  ['gradient', 'N'],
  ['residual', 'N'],
  ['change', 'm'],
] as const;

interface Props {
  step: number;
  events: readonly TraceEvent[];
  cursorHalfStep: number;
  onSeek(halfStep: number): void;
}

/** Every number of the plot as text, folded away until wanted. */
export function TraceTable({ step, events, cursorHalfStep, onSeek }: Props) {
  const [open, setOpen] = useState(false);
  const download = () => downloadText(`objective-step-${step}.csv`, 'text/csv', traceCsv(events));
  return (
    <details class="trace-table" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{t('plots.data')}</summary>
      <button type="button" onClick={download}>
        {t('plots.download')}
      </button>
      {open && <Rows events={events} cursorHalfStep={cursorHalfStep} onSeek={onSeek} />}
    </details>
  );
}

function Rows({ events, cursorHalfStep, onSeek }: Omit<Props, 'step'>) {
  return (
    <div class="trace-table-scroll">
      <table>
        <thead>
          <tr>
            <th scope="col">{t('plots.halfStep')}</th>
            {quantities.map(([name, unit]) => (
              <th key={name} scope="col">
                {t(`plots.${name}`)}, {unit}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {events.map((event) => (
            <tr key={event.half_step} aria-current={event.half_step === cursorHalfStep}>
              <th scope="row">
                <button type="button" onClick={() => onSeek(event.half_step)}>
                  {event.half_step} {t(`page.phase.${event.phase}`)}
                </button>
              </th>
              {quantities.map(([name]) => (
                <td key={name}>{Number.isNaN(event[name]) ? '–' : formatNumber(event[name], 6)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
