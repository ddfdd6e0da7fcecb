import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { norm, row, subtract } from '../../../lib/vector.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { type Moment, progressAt } from '../trace/moment.ts';
import { en } from './en.ts';
import { formatError } from './format_error.ts';
import { zh } from './zh.ts';

/** Iterations: so few still have whole numbers at their ticks. */
const fewest = 5;

/** The error after every iteration, and the place of the cursor between them. */
export function ErrorChart({ search, moment }: { search: Search; moment: Moment }) {
  const words = inLanguage({ en, zh }).result;
  const { task, answer } = search;
  const last = Math.max(fewest, answer.iterations);
  const start = norm(subtract(row(task.target, 0), row(answer.start_x, answer.start_x.length / 3 - 1)));
  return (
    <LineChart
      series={[
        { name: words.curve, points: [start, ...answer.errors].map((error, iteration) => [iteration, error]) },
        {
          name: words.tolerance,
          points: [
            [0, task.epsilon],
            [last, task.epsilon],
          ],
        },
      ]}
      x={{ label: words.iteration, range: [0, last] }}
      y={{ label: words.errorInMetres, logarithmic: true }}
      cursor={progressAt(search, moment)}
      summary={fillTemplate(words.summary, {
        before: formatError(start),
        after: formatError(answer.error),
        iterations: answer.iterations,
      })}
    />
  );
}
