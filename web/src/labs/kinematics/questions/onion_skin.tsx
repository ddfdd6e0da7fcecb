import { fillTemplate } from '../../../lib/fill_template.ts';
import type { Sweep } from '../../../solver/ik_sweep.ts';
import { type Box, obliquePoints } from './oblique.ts';
import { questionWords } from './question_words.ts';

interface Props {
  sweep: Sweep;
  /** #T×3, m. */
  targets: Float64Array;
  /** The pose in front. */
  at: number;
  /** What the picture shows. */
  box: Box;
}

/** Poses that are seen at once. */
const layers = 8;

/** The pose for a target over those for the targets before, which fade: arms that lie close together move calmly. */
export function OnionSkin({ sweep, targets, at, box }: Props) {
  const words = questionWords().jitter;
  const joints = sweep.x.length / sweep.errors.length / 3;
  const first = Math.max(0, at + 1 - layers);
  const poses = Array.from({ length: at + 1 - first }, (_, layer) => {
    const pose = first + layer;
    return { pose, points: obliquePoints(sweep.x.subarray(3 * joints * pose, 3 * joints * (pose + 1))) };
  });
  const [targetX, targetY] = obliquePoints(targets.subarray(3 * at, 3 * at + 3))[0];
  return (
    <svg
      class="onion-skin"
      viewBox={`${box.x} ${box.y} ${box.width} ${box.height}`}
      role="img"
      aria-label={fillTemplate(words.picture, { first: first + 1, last: at + 1 })}
    >
      <polygon class="onion-skin-curve" points={pathOf(obliquePoints(targets))} />
      {poses.map(({ pose, points }) => (
        <g key={pose} class={pose === at ? 'onion-skin-front' : undefined} opacity={(pose - first + 1) / poses.length}>
          <polyline points={pathOf(points)} />
          {points.map(([x, y], joint) => (
            <circle key={joint} cx={x} cy={y} r={pose === at ? 0.03 : 0.015} />
          ))}
        </g>
      ))}
      <circle class="onion-skin-target" cx={targetX} cy={targetY} r={0.05} />
    </svg>
  );
}

function pathOf(points: readonly (readonly [number, number])[]): string {
  return points.map(([x, y]) => `${x.toFixed(4)},${y.toFixed(4)}`).join(' ');
}
