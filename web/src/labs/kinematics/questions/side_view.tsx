import { useRef } from 'preact/hooks';
import type { Point3 } from '../../../app/kinematics.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatLength } from '../../../lib/format.ts';
import { useWidth } from '../../../lib/use_width.ts';
import type { Shell } from '../../../solver/ik_shell.ts';
import { questionWords } from './question_words.ts';
import { placeOf, type TargetPlace } from './target_place.ts';

interface Props {
  root: Point3;
  shell: Shell;
  /** m: what the picture shows around the root. */
  most: number;
  place: TargetPlace;
  onPlace: (place: TargetPlace) => void;
  /** #joints×3, m: with the question for the distance, and by searching alone. */
  poses: { tested: Float64Array; untested: Float64Array } | null;
}

/** The arm from the side, in the distances that it can reach. The target can be dragged. */
export function SideView({ root, shell, most, place, onPlace, poses }: Props) {
  const words = questionWords().unreachable;
  const host = useRef<HTMLDivElement>(null);
  const size = useWidth(host);
  const middle = size / 2;
  const scale = middle / (most + 0.1); // px/m, the target’s ring included
  const drawn = (x: Float64Array) =>
    Array.from({ length: x.length / 3 }, (_, joint): [number, number] => [
      middle + scale * (x[3 * joint] - root[0]),
      middle - scale * (x[3 * joint + 1] - root[1]),
    ]);
  const angle = (place.direction * Math.PI) / 180;
  const target = [middle + scale * place.distance * Math.sin(angle), middle + scale * place.distance * Math.cos(angle)];
  const drag = (event: PointerEvent & { currentTarget: SVGElement }) => {
    if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
    const box = (host.current as HTMLElement).getBoundingClientRect();
    const to = placeOf((event.clientX - box.left - middle) / scale, (middle + box.top - event.clientY) / scale);
    onPlace({ ...to, distance: Math.min(to.distance, most) });
  };

  return (
    <div ref={host} class="side-view">
      {size > 0 && (
        <svg viewBox={`0 0 ${size} ${size}`} width={size} height={size} role="img" aria-label={words.picture}>
          <circle class="side-view-reach" cx={middle} cy={middle} r={scale * shell.farthest} />
          <circle class="side-view-hole" cx={middle} cy={middle} r={scale * shell.nearest} />
          <text x={middle} y={middle - scale * shell.farthest - 8}>
            {fillTemplate(words.reach, { length: formatLength(shell.farthest) })}
          </text>
          {shell.nearest > 0 && (
            <text x={middle} y={middle - scale * shell.nearest - 8}>
              {fillTemplate(words.hole, { length: formatLength(shell.nearest) })}
            </text>
          )}
          <line class="side-view-line" x1={middle} y1={middle} x2={target[0]} y2={target[1]} />
          {poses && <Arm className="side-view-untested" joints={drawn(poses.untested)} />}
          {poses && <Arm className="side-view-tested" joints={drawn(poses.tested)} />}
          <g class="side-view-target" transform={`translate(${target[0]} ${target[1]})`}>
            <circle r={7} />
            <circle class="dot" r={2.5} />
            <circle
              class="touch"
              r={22}
              onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
              onPointerMove={drag}
            />
          </g>
        </svg>
      )}
    </div>
  );
}

function Arm({ className, joints }: { className: string; joints: readonly [number, number][] }) {
  return (
    <g class={className}>
      <polyline points={joints.map((joint) => joint.join(',')).join(' ')} />
      {joints.map(([x, y], joint) => (
        <circle key={joint} cx={x} cy={y} r={joint === 0 ? 5 : 3.5} />
      ))}
    </g>
  );
}
