import type { Checkpoint } from '../../../../solver/protocol.ts';
import type { Drawing } from '../../figures/spring_picture.tsx';
import { straightOn } from './differences.ts';
import './trail.css';

/** The vertex whose way is marked. */
export const swinging = 1;

/** Time steps of which a dot is left. */
const longest = 60;

/** Where the mass has been, its two known positions, and how it would go on if nothing pulled at it. */
export function Trail({ figure, plane }: Drawing) {
  const { p_curr, p_prev } = figure.checkpoint() as Checkpoint; // where there is a picture, there is a moment
  const past = figure.earlier().slice(-longest);
  const before = plane.place(p_prev, swinging);
  const now = plane.place(p_curr, swinging);
  const straight = plane.place(straightOn(p_curr, p_prev), swinging);
  return (
    <>
      {past.map(({ step, p_prev: been }) => {
        const [x, y] = plane.place(been, swinging);
        return <circle key={step} class="trail-dot" cx={x} cy={y} r={2.5} />;
      })}
      <path class="trail-known" d={`M${before.join(' ')}L${now.join(' ')}`} />
      <path class="trail-straight" d={`M${now.join(' ')}L${straight.join(' ')}`} />
      <circle class="trail-straight" cx={straight[0]} cy={straight[1]} r={5} />
      <Known place={before} sym="pPrev" superscript="t−Δt" />
      <Known place={now} sym="pCurr" superscript="t" />
    </>
  );
}

/** A ring at a known position, with its name. */
function Known({
  place: [x, y],
  sym,
  superscript,
}: {
  place: readonly [number, number];
  sym: string;
  superscript: string;
}) {
  return (
    <g class="trail-position" data-sym={sym}>
      <circle cx={x} cy={y} r={6} />
      <text x={x + 11} y={y + 18}>
        p
        <tspan dy={-6} class="trail-superscript">
          {superscript}
        </tspan>
      </text>
    </g>
  );
}
