import { useComputed } from '@preact/signals';
import { useId, useMemo } from 'preact/hooks';
import { litThings } from '../../../app/highlight.ts';
import { labFigure, selectedVertex } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { grouped } from '../../../lib/grouped.ts';
import type { Elimination } from '../../../solver/matrices.ts';
import { roomWords } from './room_words.ts';
import { type TreeLayout, treeLayout } from './tree_layout.ts';

/** More columns than this are no longer told apart. */
const mostDrawn = 260;
/** Units of the drawing. */
const across = 14;
const down = 16;
const edge = 10;

interface Props {
  elimination: Elimination;
  /** How many columns are eliminated. */
  eliminated: number;
}

/** Which column of L waits for which. */
export function EliminationTree({ elimination, eliminated }: Props) {
  const words = roomWords().elimination.tree;
  const heading = useId();
  const layout = useMemo(() => treeLayout(elimination.parent), [elimination]);
  const { leaves, roots, height } = layout;
  const count = elimination.order.length;
  const summary = fillTemplate(words.summary, { count: grouped(count), height, leaves, roots });
  return (
    <section class="elimination-tree" aria-labelledby={heading}>
      <h3 id={heading}>{words.title}</h3>
      <p class="aside">{words.text}</p>
      {count > mostDrawn ? <p>{words.tooLarge}</p> : <Drawing {...{ elimination, eliminated, layout, summary }} />}
      <p class="aside" data-testid="tree">
        {summary}
      </p>
    </section>
  );
}

function Drawing({ elimination, eliminated, layout, summary }: Props & { layout: TreeLayout; summary: string }) {
  const { order, parent } = elimination;
  const { x, depth, leaves, height } = layout;
  const lit = useComputed(() => litThings(labFigure).vertex ?? selectedVertex.value);
  const place = (column: number) => [edge + across * x[column], edge + down * depth[column]] as const;
  const width = 2 * edge + across * Math.max(0, leaves - 1);
  const tall = 2 * edge + down * Math.max(0, height - 1);
  return (
    <svg viewBox={`0 0 ${width} ${tall}`} style={{ maxWidth: `${width * 1.4}px` }} role="img" aria-label={summary}>
      {Array.from(parent, (above, column) => {
        if (above < 0) return null;
        const [x1, y1] = place(column);
        const [x2, y2] = place(above);
        return <line key={column} x1={x1} y1={y1} x2={x2} y2={y2} />;
      })}
      {Array.from(order, (vertex, column) => {
        const [cx, cy] = place(column);
        const state = column < eliminated ? 'done' : 'waiting';
        return (
          <circle
            key={column}
            class={`${state} ${lit.value === vertex ? 'lit' : ''}`}
            cx={cx}
            cy={cy}
            r={4.5}
            data-vertex={vertex}
          >
            <title>{`${column} (${vertex})`}</title>
          </circle>
        );
      })}
    </svg>
  );
}
