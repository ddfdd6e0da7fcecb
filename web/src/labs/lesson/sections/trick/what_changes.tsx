import { useRef } from 'preact/hooks';
import { formatVector } from '../../../../lib/format.ts';
import { row } from '../../../../lib/vector.ts';
import type { SymbolId } from '../../../../notation/symbols.ts';
import { SymbolButton } from '../../../../views/equations/symbol_button.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { type Seen, useInspection } from '../../figures/use_inspection.ts';
import type { en } from './en.ts';

const settings: FigureSettings = {
  scene: 'patch',
  parameters: { iterations: 3 },
  selection: { spring: 6, vertex: 3 },
  opening: [{ kind: 'play', steps: 9 }, { kind: 'next_half_step' }, { kind: 'next_half_step' }],
};

const ids = ['pCurr', 'y', 'd', 'b', 'p'] as const satisfies readonly SymbolId[];

/** What stands still during the iterations of a time step, and what does not. */
export function WhatChanges({ words }: { words: typeof en.loops }) {
  const figure = useFigure(settings);
  const seen = useInspection(figure);
  const before = useRef<{ now: Seen | null; last: Seen | null }>({ now: null, last: null });
  if (seen !== before.current.now) before.current = { now: seen, last: before.current.now };
  const { last } = before.current;
  const { spring, vertex } = figure.selection.value;

  return (
    <Figure figure={figure} pictures={['torn', 'net']} caption={words.caption}>
      <table class="numbers what-changes">
        <tbody>
          {ids.map((id) => {
            const value = seen && textOf(id, seen, spring ?? 0, vertex ?? 0);
            const changed = last && value !== textOf(id, last, spring ?? 0, vertex ?? 0);
            return (
              <tr key={id} data-changed={changed === true}>
                <th scope="row">
                  <SymbolButton id={id} />
                </th>
                <td>{value ?? '…'}</td>
                <td class="visually-hidden">{changed ? words.changed : ''}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </Figure>
  );
}

/** Of vectors in the plane, x and y. */
function textOf(id: (typeof ids)[number], { frame, p_curr, equations }: Seen, spring: number, vertex: number): string {
  const known = frame.phase !== 'predict';
  switch (id) {
    case 'pCurr':
      return written(row(p_curr, vertex), 'm');
    case 'y':
      return written(equations[vertex].y, 'N');
    case 'd':
      return frame.d ? written(row(frame.d, spring), 'm') : '–';
    case 'b':
      return known ? written(equations[vertex].b, 'N') : '–'; // without d there is no b
    case 'p':
      return written(row(frame.p, vertex), 'm');
  }
}

function written(vector: readonly number[], unit: string): string {
  return formatVector(vector.slice(0, 2), unit, 5);
}
