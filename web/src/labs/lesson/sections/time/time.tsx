import { encodeLink } from '../../../../app/link.ts';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { integratorsRoute } from '../../../../app/route.ts';
import { state } from '../../../../app/state.ts';
import type { Frame } from '../../../../solver/frame.ts';
import type { Checkpoint } from '../../../../solver/protocol.ts';
import { Display } from '../../../../views/equations/display.tsx';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import type { Arrows } from '../../figures/arrows.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { InSlices } from '../../in_slices.tsx';
import { Sources } from '../../sources.tsx';
import { DifferenceTable } from './difference_table.tsx';
import { straightOn } from './differences.ts';
import { en } from './en.ts';
import { FourSteps } from './four_steps.tsx';
import { Trail } from './trail.tsx';
import { zh } from './zh.ts';

/** Steps long enough that their positions lie well apart. */
const swing: FigureSettings = {
  scene: 'single-spring-horizontal',
  parameters: { delta_t: 0.08 },
  selection: { spring: null, vertex: null },
  opening: [{ kind: 'play', steps: 5 }],
};

const { raw } = String;

const acceleration = raw`\begin{aligned}\syma_i &\approx \frac{1}{\symdeltaT}\left(\frac{\symp_i - \sympCurr_i}{\symdeltaT} - \frac{\sympCurr_i - \sympPrev_i}{\symdeltaT}\right)\\[4pt] &= \frac{\symp_i - 2\sympCurr_i + \sympPrev_i}{\symdeltaT^2}\end{aligned}`;

export function Time() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(swing);
  const bend = ({ p }: Frame): Arrows => {
    const { p_curr, p_prev } = figure.checkpoint() as Checkpoint; // where there is a frame, there is a moment
    return { from: straightOn(p_curr, p_prev), to: p, symbol: 'a' };
  };
  return (
    <InSlices>
      <Prose text={words.intro} />
      <h3>{words.differences.title}</h3>
      <Prose text={words.differences.velocity} />
      <Display tex={acceleration} />
      <Prose text={words.differences.roles} />
      <Figure
        figure={figure}
        pictures={['net']}
        arrows={bend}
        behind={Trail}
        sliders={['delta_t', 'k']}
        caption={words.swing.caption}
      >
        <DifferenceTable figure={figure} />
      </Figure>
      <h3>{words.size.title}</h3>
      <Question ask={words.size.ask} hint={words.size.hint} answer={words.size.answer}>
        <FourSteps />
        <p>
          <a href={encodeLink(integratorsRoute, state.value)}>{words.size.order}</a>
        </p>
      </Question>
      <Sources items={words.sources} />
    </InSlices>
  );
}
