import './pattern_plot.css';

/** Entries that are drawn alike. */
export interface PatternLayer {
  kind: 'entry' | 'fill';
  /** (row, column). */
  places: readonly (readonly [number, number])[];
}

interface Props {
  /** Rows and columns. */
  n: number;
  layers: readonly PatternLayer[];
  /** What it is, with its counts. */
  label: string;
}

/** Where a matrix is not zero. */
export function PatternPlot({ n, layers, label }: Props) {
  return (
    <figure class="pattern-plot">
      <svg viewBox={`0 0 ${n} ${n}`} role="img" aria-label={label}>
        {layers.map(({ kind, places }) => (
          <path key={kind} class={kind} d={places.map(([row, column]) => `M${column} ${row}h1v1h-1z`).join('')} />
        ))}
      </svg>
      <figcaption aria-hidden="true">{label}</figcaption>
    </figure>
  );
}
