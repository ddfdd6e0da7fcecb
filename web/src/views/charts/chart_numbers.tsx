import { formatNumber } from '../../lib/format.ts';
import type { ChartAxis, Series } from './line_chart.tsx';

interface Props {
  series: readonly Series[];
  x: ChartAxis;
  y: ChartAxis;
}

/** The same numbers as a table: a row for every x of any curve. */
export function ChartNumbers({ series, x, y }: Props) {
  const places = [...new Set(series.flatMap(({ points }) => points.map(([at]) => at)))].sort((a, b) => a - b);
  const columns = series.map(({ name, points }) => ({
    name,
    values: new Map(points.map(([at, value]) => [at, value])),
  }));
  return (
    <table>
      <caption>{y.label}</caption>
      <thead>
        <tr>
          <th scope="col">{x.label}</th>
          {columns.map(({ name }) => (
            <th key={name} scope="col">
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {places.map((at) => (
          <tr key={at}>
            <th scope="row">{Number.isInteger(at) ? at : formatNumber(at)}</th>
            {columns.map(({ name, values }) => {
              const value = values.get(at);
              return <td key={name}>{value === undefined ? '' : formatNumber(value)}</td>;
            })}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
