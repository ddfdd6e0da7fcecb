import { useRef } from 'preact/hooks';
import { Phrase } from '../../../../views/equations/prose.tsx';
import { changesBetween, type Numbers } from '../../figures/changes.ts';
import { denseValues } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';

const hanging: FigureSettings = { scene: 'triangle', parameters: { w: 1e6 }, selection: { spring: 0, vertex: 0 } };

const counted = ['Q', 'b'] as const;

/** How often Q and b have changed since the figure came up. */
export function ChangeCounters({ words }: { words: Record<'caption' | 'q' | 'b', string> }) {
  const figure = useFigure(hanging);
  const seen = useInspection(figure);
  const counts = useRef({ Q: 0, b: 0 });
  const last = useRef<{ seen: Seen; numbers: Numbers } | null>(null);
  if (seen && last.current?.seen !== seen) {
    const numbers = { Q: denseValues(seen.Q), b: Float64Array.from(seen.equations.flatMap(({ b }) => b)) };
    const changed = changesBetween(last.current?.numbers ?? numbers, numbers);
    for (const id of counted) if (changed.has(id)) counts.current[id]++;
    last.current = { seen, numbers };
  }
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k', 'w']} caption={words.caption}>
      <dl class="pins-numbers">
        {counted.map((id) => (
          <div key={id}>
            <dt>
              <Phrase text={id === 'Q' ? words.q : words.b} />
            </dt>
            <dd data-testid={`changes-of-${id}`}>{counts.current[id]}</dd>
          </div>
        ))}
      </dl>
    </Figure>
  );
}
