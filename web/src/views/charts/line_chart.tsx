import type { ComponentChildren } from 'preact';
import { useId, useRef, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { formatPowerOfTen } from '../../lib/format.ts';
import { useWidth } from '../../lib/use_width.ts';
import { type Range, rangeOf, share, ticks } from './chart_axis.ts';
import { ChartNumbers } from './chart_numbers.tsx';
import { LineEnds, widthOfEnds } from './line_ends.tsx';
import './line_chart.css';

/** CSS pixels, y downwards. */
type Place = readonly [x: number, y: number];

export interface Series {
  name: string;
  /** In the order of x. */
  points: readonly (readonly [x: number, y: number])[];
  /** Dots without a line between them: measurements. */
  dots?: boolean;
  /** A law fitted to the last of the points, drawn through the dots. */
  law?: Series['points'];
  /** Written beside the end of the line, right of the chart: a few characters. */
  end?: string;
}

export interface ChartAxis {
  /** One phrase, with the unit. */
  label: ComponentChildren;
  logarithmic?: boolean;
  /** Where the values do not say it. */
  range?: readonly [min: number, max: number];
}

interface Props {
  series: readonly Series[];
  x: ChartAxis;
  y: ChartAxis;
  /** The x to mark. */
  cursor?: number;
  /** What is to be seen, for those who cannot see it. */
  summary: string;
}

const height = 240; // px
/** Characters: the margin has room for no more. */
const longestTick = 7;
const usualMargin = { left: 56, right: 12, top: 8, bottom: 28 }; // px

/** A few curves in one frame, told apart by colour, dashes and name; their numbers in a table. */
export function LineChart({ series, x, y, cursor, summary }: Props) {
  const frame = useId();
  const host = useRef<HTMLDivElement>(null);
  const width = useWidth(host);
  const margin = { ...usualMargin, right: usualMargin.right + widthOfEnds(series.map(({ end = '' }) => end)) };
  const across = axisRange(x, series, 0);
  const along = axisRange(y, series, 1);
  const place = {
    x: toPlace(across, margin.left, width - margin.right),
    y: toPlace(along, height - margin.bottom, margin.top),
  };
  const placed = (points: Series['points']): Place[] =>
    points.filter((point) => point.every(Number.isFinite)).map(([a, b]) => [place.x(a), place.y(b)]);
  const ends = series.flatMap(({ points, end }, curve) => {
    const last = placed(points).at(-1);
    return end && last ? [{ curve, text: end, y: last[1] }] : [];
  });

  return (
    <figure class="line-chart">
      <p class="line-chart-label">{y.label}</p>
      <div ref={host} style={{ height: `${height}px` }}>
        {width > margin.left + margin.right && (
          <svg viewBox={`0 0 ${width} ${height}`} width={width} height={height} role="img" aria-label={summary}>
            {ticks(across).map((value) => (
              <g key={value} class="line-chart-tick">
                <line x1={place.x(value)} x2={place.x(value)} y1={margin.top} y2={height - margin.bottom} />
                <text x={place.x(value)} y={height - 8} text-anchor="middle">
                  {tickText(value, across)}
                </text>
              </g>
            ))}
            {ticks(along).map((value) => (
              <g key={value} class="line-chart-tick">
                <line x1={margin.left} x2={width - margin.right} y1={place.y(value)} y2={place.y(value)} />
                <text x={margin.left - 8} y={place.y(value) + 4} text-anchor="end">
                  {tickText(value, along)}
                </text>
              </g>
            ))}
            {cursor !== undefined && (
              <line
                class="line-chart-cursor"
                x1={place.x(cursor)}
                x2={place.x(cursor)}
                y1={margin.top}
                y2={height - margin.bottom}
              />
            )}
            <clipPath id={frame}>
              <rect
                x={margin.left}
                y={0}
                width={width - margin.left - margin.right + usualMargin.right}
                height={height - margin.bottom}
              />
            </clipPath>
            <g clip-path={`url(#${frame})`}>
              {series.map(({ name, points, dots = false, law }, at) => (
                <g key={name} class={`curve curve-${at}`}>
                  {dots ? <Dots places={placed(points)} /> : <Line places={placed(points)} />}
                  {law && <Line places={placed(law)} />}
                </g>
              ))}
            </g>
            <LineEnds ends={ends} x={width - margin.right + 8} top={margin.top} bottom={height - margin.bottom} />
          </svg>
        )}
      </div>
      <p class="line-chart-label line-chart-x">{x.label}</p>
      <ul class="line-chart-names">
        {series.map(({ name, dots = false, law }, at) => (
          <li key={name}>
            <svg width="28" height="10" aria-hidden="true" class={`curve curve-${at}`}>
              {dots && <circle cx="14" cy="5" r="3.5" />}
              {(!dots || law) && <path d="M0 5H28" />}
            </svg>
            {name}
          </li>
        ))}
      </ul>
      <Numbers series={series} x={x} y={y} />
    </figure>
  );
}

/** Made only while they are looked at: a chart that grows would make them again and again. */
function Numbers(numbers: Pick<Props, 'series' | 'x' | 'y'>) {
  const [open, setOpen] = useState(false);
  return (
    <details class="line-chart-numbers" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{t('plots.numbers')}</summary>
      {open && <ChartNumbers {...numbers} />}
    </details>
  );
}

function Dots({ places }: { places: readonly Place[] }) {
  return (
    <>
      {places.map(([x, y]) => (
        <circle key={x} cx={x} cy={y} r={3.5} />
      ))}
    </>
  );
}

function Line({ places }: { places: readonly Place[] }) {
  return <path d={places.map(([x, y], at) => `${at === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`).join('')} />;
}

function axisRange({ logarithmic = false, range }: ChartAxis, series: readonly Series[], coordinate: 0 | 1): Range {
  if (range) return { min: range[0], max: range[1], logarithmic };
  return rangeOf(
    series.flatMap(({ points }) => points.map((point) => point[coordinate])),
    logarithmic,
  );
}

function toPlace(range: Range, from: number, to: number): (value: number) => number {
  return (value) => from + (to - from) * Math.min(1.5, Math.max(-0.5, share(value, range)));
}

function tickText(value: number, { logarithmic }: Range): string {
  if (logarithmic) return formatPowerOfTen(Math.round(Math.log10(value)));
  const plain = String(value).replace('-', '−');
  if (plain.length <= longestTick) return plain;
  const [mantissa, exponent] = value.toExponential().split('e');
  return `${mantissa.replace('-', '−')}·${formatPowerOfTen(Number(exponent))}`;
}
