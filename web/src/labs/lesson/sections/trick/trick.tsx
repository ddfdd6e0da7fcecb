import { moves } from '../../figures/arrows.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { Prose } from '../../prose.tsx';
import { Question } from '../../question.tsx';
import { Sources } from '../../sources.tsx';
import { inLanguage } from '../../text.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

const halfSteps: FigureSettings = {
  scene: 'patch',
  parameters: { iterations: 4 },
  selection: { spring: 6, vertex: 3 },
  opening: [{ kind: 'play', steps: 4 }, { kind: 'next_half_step' }, { kind: 'next_half_step' }],
};

export function Trick() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(halfSteps);
  return (
    <>
      <Prose text={words.intro} />
      <Figure
        figure={figure}
        pictures={['torn', 'net']}
        arrows={moves}
        sliders={['k', 'iterations']}
        caption={words.intro}
      />
      <Question ask={words.intro} hint={words.intro} answer={words.intro} />
      <Sources items={{ a: words.intro }} />
    </>
  );
}
