import { inLanguage } from '../../../../app/messages/in_language.ts';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { InSlices } from '../../in_slices.tsx';
import { RoomLink } from '../../room_link.tsx';
import { Sources } from '../../sources.tsx';
import { en } from './en.ts';
import { InverseExperiment } from './inverse_experiment.tsx';
import { RefactorisingExperiment } from './refactorising_experiment.tsx';
import './solving.css';
import { SubstitutionFigure } from './substitution_figure.tsx';
import { TimingExperiment } from './timing_experiment.tsx';
import { zh } from './zh.ts';

/** A penalty small enough for its row to be read beside the others. */
const byHand: FigureSettings = {
  scene: 'square',
  parameters: { w: 1000, iterations: 4 },
  selection: { spring: null, vertex: 3 },
  opening: [
    { kind: 'play', steps: 3 },
    { kind: 'next_half_step' },
    { kind: 'next_half_step' },
    { kind: 'next_half_step' },
  ],
};

export function Solving() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(byHand);
  return (
    <InSlices>
      <Prose text={words.action} />
      <Figure figure={figure} pictures={['net']} sliders={['k']} caption={words.substitution.caption}>
        <SubstitutionFigure figure={figure} />
      </Figure>
      <Prose text={words.precompute} />
      <Question {...words.refactorise}>
        <RefactorisingExperiment />
      </Question>
      <h3>{words.costTitle}</h3>
      <Prose text={words.cost} />
      <TimingExperiment />
      <Prose text={words.reading} />
      <Question {...words.whyNotInverse}>
        <InverseExperiment />
      </Question>
      <RoomLink room="matrices" />
      <Sources items={words.sources} />
    </InSlices>
  );
}
