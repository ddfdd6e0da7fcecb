import type { KinematicsSession, Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { norm, row, subtract } from '../../../lib/vector.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { momentAt, progressAt } from '../trace/moment.ts';
import { en } from './en.ts';
import { formatError } from './format_error.ts';
import { zh } from './zh.ts';

const mm = 1000; // in a metre

/** Iterations: so few still have whole numbers at their ticks. */
const fewest = 5;

/** The error after every iteration, and the place of the cursor between them. */
export function ErrorChart({ session }: { session: KinematicsSession }) {
  const words = inLanguage({ en, zh }).errors;
  const search = session.search.value as Search; // the lab is shown once there is one
  const { task, answer } = search;
  if (answer.iterations === 0) return null;
  const last = Math.max(fewest, answer.iterations);
  const start = norm(subtract(row(task.target, 0), row(answer.start_x, answer.start_x.length / 3 - 1)));
  return (
    <section class="arm-errors" aria-labelledby="arm-errors-heading">
      <h3 id="arm-errors-heading">{words.heading}</h3>
      <LineChart
        series={[
          { name: words.curve, points: [start, ...answer.errors].map((error, iteration) => [iteration, mm * error]) },
          {
            name: words.tolerance,
            points: [
              [0, mm * task.epsilon],
              [last, mm * task.epsilon],
            ],
          },
        ]}
        x={{ label: words.iteration, range: [0, last] }}
        y={{ label: words.label, logarithmic: true }}
        cursor={progressAt(search, momentAt(search, session.event.value))}
        summary={fillTemplate(words.summary, {
          before: formatError(start),
          after: formatError(answer.error),
          iterations: answer.iterations,
        })}
      />
    </section>
  );
}
