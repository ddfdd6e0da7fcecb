import { useMemo, useRef, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { parameters } from '../../app/state.ts';
import { asRanges } from '../../lib/as_ranges.ts';
import { formatQuantity } from '../../lib/format.ts';
import type { Frame } from '../../solver/frame.ts';
import { ObjectivePlot } from './objective_plot.ts';
import { objectiveTrace } from './objective_trace.ts';
import { placeText, TraceReadout } from './trace_readout.tsx';
import { TraceTable } from './trace_table.tsx';
import { usePlot } from './use_plot.ts';

interface Props {
  frame: Frame;
  onSeek(halfStep: number): void;
}

/** The plot of one time step's objective with its numbers as text; while playing, the last one seen, in grey. */
export function ObjectiveChart({ frame, onSeek }: Props) {
  const lastTraced = useRef<Frame | null>(null);
  if (frame.events.length > 0) lastTraced.current = frame;
  const traced = lastTraced.current;

  if (!traced) return <p class="objective-note">{t('plots.invite')}</p>;
  return <Trace frame={traced} stale={traced !== frame} onSeek={onSeek} />;
}

function Trace({ frame, stale, onSeek }: Props & { stale: boolean }) {
  const { events, step, half_step: cursorHalfStep, last_half_step: lastHalfStep } = frame;
  const { method } = parameters.value;
  const [inspectedHalfStep, inspect] = useState<number | null>(null);
  const points = useMemo(() => objectiveTrace(events), [events]);
  const marks = useMemo(
    () => ({ points, cursorHalfStep, lastHalfStep, inspectedHalfStep, stale }),
    [points, cursorHalfStep, lastHalfStep, inspectedHalfStep, stale],
  );
  const host = usePlot((element) => new ObjectivePlot(element, { onInspect: inspect, onSeek }), marks);

  const shown = points[inspectedHalfStep ?? cursorHalfStep];
  const highest = formatQuantity(Math.max(...points.map(({ height }) => height ?? 0)), 'J');
  const atLowest = points.filter(({ height }) => height === null).map(({ event }) => event.half_step);

  return (
    <>
      <p class="objective-legend">
        <span>{t('plots.height')}</span>
        <span class="objective-local">◆ {t('page.phase.local')}</span>
        <span class="objective-global">■ {t('page.phase.global')}</span>
      </p>
      <input
        type="range"
        class="visually-hidden"
        aria-label={t('plots.inspect')}
        aria-valuetext={shown ? placeText(shown.event) : ''}
        title={t('plots.inspectHelp')}
        min={0}
        max={events.length - 1}
        value={inspectedHalfStep ?? cursorHalfStep}
        onInput={(event) => inspect(event.currentTarget.valueAsNumber)}
        onBlur={() => inspect(null)}
        onKeyDown={(event) => {
          if (event.key === 'Enter') onSeek(event.currentTarget.valueAsNumber);
        }}
      />
      <div
        ref={host}
        class="objective-plot"
        role="img"
        aria-label={t('plots.label', { step, count: events.length, highest })}
      />
      <p class="objective-axis">{t('plots.halfStep')}</p>
      {method !== 'local-global' && (
        <p class="objective-note">{t('plots.notHeld', { method: t(`methods.name.${method}`) })}</p>
      )}
      {atLowest.length > 0 && <p class="objective-note">{t('plots.atLowest', { list: asRanges(atLowest) })}</p>}
      {stale ? <p class="objective-note">{t('plots.stale', { step })}</p> : shown && <TraceReadout point={shown} />}
      <TraceTable step={step} events={events} cursorHalfStep={cursorHalfStep} onSeek={onSeek} />
    </>
  );
}
