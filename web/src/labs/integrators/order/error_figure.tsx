import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatFixed, formatLength } from '../../../lib/format.ts';
import type { Errors } from '../../../solver/order_of_accuracy.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { Phrase } from '../../../views/equations/prose.tsx';
import { namesOf } from '../names.ts';
import { en } from './en.ts';
import { linesOf, slopeOf } from './lines.ts';
import { Swatch } from './swatch.tsx';
import { zh } from './zh.ts';

/** Error against Δt, both axes logarithmic, and the slopes as a table. */
export function ErrorFigure({ methods }: { methods: readonly Errors[] }) {
  const words = inLanguage({ en, zh }).errors;
  const names = namesOf(methods.map(({ way }) => ({ ...way, substeps: 1 })));
  const lines = linesOf(methods);
  const steps = methods[0].errors.map(({ delta_t }) => delta_t);
  return (
    <>
      <LineChart
        series={lines.map(({ members, points, slope }) => ({
          name: members.map((at) => names[at]).join(' = '),
          points,
          end: fillTemplate(words.slope, { slope: formatFixed(slope, 2) }),
        }))}
        x={{
          label: <Phrase text={words.delta_t} />,
          logarithmic: true,
          range: [Math.min(...steps), Math.max(...steps)],
        }}
        y={{ label: words.error, logarithmic: true }}
        summary={words.summary}
      />
      <table class="results order-slopes">
        <caption>{words.caption}</caption>
        <thead>
          <tr>
            <th scope="col">{words.method}</th>
            <th scope="col">{words.order}</th>
            <th scope="col">{words.finest}</th>
          </tr>
        </thead>
        <tbody>
          {methods.map((method, at) => (
            <tr key={names[at]}>
              <th scope="row">
                <Swatch curve={lines.findIndex(({ members }) => members.includes(at))} />
                {names[at]}
              </th>
              <td>{formatFixed(slopeOf(method), 2)}</td>
              <td>{formatLength(method.errors[method.errors.length - 1].error)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </>
  );
}
