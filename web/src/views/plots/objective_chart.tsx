import { useEffect, useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { appliedTheme } from '../../app/preferences.ts';
import { asRanges } from '../../lib/as_ranges.ts';
import { formatQuantity } from '../../lib/format.ts';
import type { Frame } from '../../solver/frame.ts';
import { ObjectivePlot, type ObjectivePlotCallbacks, type ObjectivePlotState } from './objective_plot.ts';
import { objectiveTrace } from './objective_trace.ts';
import { placeText, TraceReadout } from './trace_readout.tsx';
import { TraceTable } from './trace_table.tsx';
import 'uplot/dist/uPlot.min.css';
import '../../notation/colours.css';
import './plots.css';

interface Props {
  frame: Frame;
  onSeek(halfStep: number): void;
}

/** The plot of one time step's objective with its numbers as text; while playing, the last one seen, in grey. */
export function ObjectiveChart({ frame, onSeek }: Props) {
  const lastTraced = useRef<Frame | null>(null);
  if (frame.events.length > 0) lastTraced.current = frame;
  const traced = lastTraced.current;

  return (
    <figure class="objective">
      <figcaption>{t('plots.title')}</figcaption>
      {traced ? (
        <Trace frame={traced} stale={traced !== frame} onSeek={onSeek} />
      ) : (
        <p class="objective-note">{t('plots.invite')}</p>
      )}
    </figure>
  );
}

function Trace({ frame, stale, onSeek }: Props & { stale: boolean }) {
  const { events, step, half_step: cursorHalfStep, last_half_step: lastHalfStep } = frame;
  const [inspectedHalfStep, inspect] = useState<number | null>(null);
  const points = useMemo(() => objectiveTrace(events), [events]);
  const marks = { points, cursorHalfStep, lastHalfStep, inspectedHalfStep, stale };
  const host = usePlot(marks, { onInspect: inspect, onSeek });

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
      {atLowest.length > 0 && <p class="objective-note">{t('plots.atLowest', { list: asRanges(atLowest) })}</p>}
      {stale ? <p class="objective-note">{t('plots.stale', { step })}</p> : shown && <TraceReadout point={shown} />}
      <TraceTable step={step} events={events} cursorHalfStep={cursorHalfStep} onSeek={onSeek} />
    </>
  );
}

/** Keeps an ObjectivePlot in the element that the returned ref is given to. */
function usePlot(state: ObjectivePlotState, callbacks: ObjectivePlotCallbacks) {
  const host = useRef<HTMLDivElement>(null);
  const plot = useRef<ObjectivePlot | null>(null);
  const latest = useRef(callbacks);
  latest.current = callbacks;

  useLayoutEffect(() => {
    const element = host.current as HTMLDivElement;
    const made = new ObjectivePlot(element, {
      onInspect: (halfStep) => latest.current.onInspect(halfStep),
      onSeek: (halfStep) => latest.current.onSeek(halfStep),
    });
    plot.current = made;
    const resizing = new ResizeObserver(() => made.resize());
    resizing.observe(element);
    return () => {
      resizing.disconnect();
      made.destroy();
    };
  }, []);

  const { points, cursorHalfStep, lastHalfStep, inspectedHalfStep, stale } = state;
  useLayoutEffect(() => {
    plot.current?.update({ points, cursorHalfStep, lastHalfStep, inspectedHalfStep, stale });
  }, [points, cursorHalfStep, lastHalfStep, inspectedHalfStep, stale]);

  const theme = appliedTheme.value;
  useEffect(() => plot.current?.setTheme(), [theme]);
  return host;
}
