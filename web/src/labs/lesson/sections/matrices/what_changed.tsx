import { useRef } from 'preact/hooks';
import { symbolCommand } from '../../../../notation/macros.ts';
import type { SymbolId } from '../../../../notation/symbols.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { changesBetween, type Numbers } from '../../figures/changes.ts';
import { denseValues } from '../../figures/dense_values.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';

const hanging: FigureSettings = {
  scene: 'patch',
  parameters: { iterations: 5 },
  selection: { spring: 6, vertex: 3 },
  opening: [{ kind: 'next_half_step' }],
};

type Words = Record<'caption' | 'changed' | 'same', string>;

/** Which of the matrices the last change of the figure changed. */
export function WhatChanged({ words }: { words: Words }) {
  const figure = useFigure(hanging);
  const seen = useInspection(figure);
  // The last two things seen: what is shown now is compared with what was shown before.
  const shown = useRef<{ seen: Seen; numbers: Numbers; changed: ReadonlySet<SymbolId> } | null>(null);
  if (seen && shown.current?.seen !== seen) {
    const numbers = numbersOf(seen);
    shown.current = { seen, numbers, changed: changesBetween(shown.current?.numbers ?? numbers, numbers) };
  }
  const { numbers, changed } = shown.current ?? { numbers: {}, changed: new Set() };
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k', 'mass_scale']} caption={words.caption}>
      <ul class="what-changed">
        {(Object.keys(numbers) as SymbolId[]).map((id) => (
          <li key={id} data-changed={changed.has(id)}>
            <Formula tex={symbolCommand(id)} /> {changed.has(id) ? words.changed : words.same}
          </li>
        ))}
      </ul>
    </Figure>
  );
}

function numbersOf({ A, M, Q, frame, equations }: Seen): Numbers {
  return {
    A: denseValues(A),
    M: denseValues(M),
    Q: denseValues(Q),
    p: frame.p,
    d: frame.d ?? new Float64Array(0),
    b: Float64Array.from(equations.flatMap(({ b }) => b)),
  };
}
