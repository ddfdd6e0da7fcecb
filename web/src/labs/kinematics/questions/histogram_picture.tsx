import { useRef } from 'preact/hooks';
import { useWidth } from '../../../lib/use_width.ts';
import { ikOutcomes } from '../../../solver/inverse_kinematics.ts';
import { ticks } from '../../../views/charts/chart_axis.ts';
import type { Bin } from './histogram.ts';

interface Props {
  name: string;
  summary: string;
  bins: readonly Bin[];
  axis: string;
}

const height = 128; // px
const margin = { left: 36, right: 4, top: 10, bottom: 22 }; // px

/** Bars as high as there are targets, in as many parts as searches ended in different ways. */
export function HistogramPicture({ name, summary, bins, axis }: Props) {
  const host = useRef<HTMLDivElement>(null);
  const width = useWidth(host);
  const highest = Math.max(...bins.map(({ count }) => count));
  const slot = (width - margin.left - margin.right) / bins.length;
  const end = bins[bins.length - 1].to;
  const x = (iterations: number) => margin.left + (iterations * slot * bins.length) / (end + 1);
  const y = (count: number) => height - margin.bottom - (count / highest) * (height - margin.top - margin.bottom);
  return (
    <figure class="histogram">
      <figcaption>
        <strong>{name}</strong> <span>{summary}</span>
      </figcaption>
      <div ref={host} style={{ height: `${height}px` }}>
        {width > 0 && (
          <svg
            viewBox={`0 0 ${width} ${height}`}
            width={width}
            height={height}
            role="img"
            aria-label={`${name}: ${summary}`}
          >
            {[0, highest].map((count) => (
              <g key={count} class="line-chart-tick">
                <line x1={margin.left} x2={width - margin.right} y1={y(count)} y2={y(count)} />
                <text x={margin.left - 6} y={y(count) + 5} text-anchor="end">
                  {count}
                </text>
              </g>
            ))}
            {ticks({ min: 0, max: end, logarithmic: false }).map((iterations) => (
              <g key={iterations} class="line-chart-tick">
                <text x={x(iterations + 0.5)} y={height - 5} text-anchor="middle">
                  {iterations}
                </text>
              </g>
            ))}
            {bins.map((bin) => (
              <Bar key={bin.from} bin={bin} x={x(bin.from) + 0.5} width={Math.max(1, slot - 1)} y={y} />
            ))}
          </svg>
        )}
      </div>
      <p class="histogram-axis" aria-hidden="true">
        {axis}
      </p>
    </figure>
  );
}

function Bar({ bin, x, width, y }: { bin: Bin; x: number; width: number; y: (count: number) => number }) {
  let below = 0;
  return (
    <>
      {ikOutcomes.map((outcome) => {
        const count = bin.ends[outcome];
        below += count;
        const top = y(below);
        return (
          count > 0 && (
            <rect
              key={outcome}
              class={`histogram-${outcome}`}
              x={x}
              y={top}
              width={width}
              height={y(below - count) - top}
            />
          )
        );
      })}
    </>
  );
}
