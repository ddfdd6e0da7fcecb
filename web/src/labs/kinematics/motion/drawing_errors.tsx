import { useComputed } from '@preact/signals';
import type { Drawing } from '../../../app/kinematics_drawing.ts';
import type { KinematicsSession } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatLength } from '../../../lib/format.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** While the arm draws the cursor jumps so many targets at once: nobody could follow it one by one. */
const jump = 6;

const mm = 1000; // in a metre

/** How near the arm came to every target of the drawing. */
export function DrawingErrors({ session, drawing }: { session: KinematicsSession; drawing: Drawing }) {
  const words = inLanguage({ en, zh }).errors;
  const cursor = useComputed(() => {
    const place = session.place.value;
    return 1 + (session.playing.value ? place - (place % jump) : place);
  });
  const { epsilon } = drawing;
  const { errors, iterations } = drawing.followed;
  const worst = errors.reduce((most, error) => Math.max(most, error), 0);
  const said = {
    worst: formatLength(worst),
    at: errors.indexOf(worst) + 1,
    count: errors.length,
    missed: errors.reduce((count, error) => count + (error > epsilon ? 1 : 0), 0),
    epsilon: formatLength(epsilon),
    iterations: iterations.reduce((most, count) => Math.max(most, count), 0),
  };
  return (
    <section class="drawing-errors" aria-labelledby="drawing-errors-heading">
      <h3 id="drawing-errors-heading">{words.heading}</h3>
      <LineChart
        series={[
          { name: words.error, points: Array.from(errors, (error, i) => [i + 1, mm * error] as const) },
          {
            name: words.within,
            points: [
              [1, mm * epsilon],
              [errors.length, mm * epsilon],
            ],
          },
        ]}
        x={{ label: words.target, range: [1, Math.max(2, errors.length)] }}
        y={{ label: words.label, logarithmic: true }}
        cursor={cursor.value}
        summary={fillTemplate(words.summary, said)}
      />
      <p class="drawing-errors-said">{fillTemplate(words.said, said)}</p>
    </section>
  );
}
