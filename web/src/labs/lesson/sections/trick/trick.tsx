import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatQuantity } from '../../../../lib/format.ts';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import { moves } from '../../figures/arrows.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { InSlices } from '../../in_slices.tsx';
import { Sources } from '../../sources.tsx';
import { en } from './en.ts';
import { Energies } from './energies.tsx';
import { EnoughRounds, tolerance } from './enough_rounds.tsx';
import { PeanutButter } from './peanut_butter.tsx';
import { StoppingRules } from './stopping_rules.tsx';
import { WhatChanges } from './what_changes.tsx';
import { zh } from './zh.ts';

const tornAndStitched: FigureSettings = {
  scene: 'patch',
  parameters: { iterations: 4 },
  selection: { spring: 6, vertex: 3 },
  opening: [{ kind: 'play', steps: 9 }, { kind: 'next_half_step' }, { kind: 'next_half_step' }],
};

export function Trick() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(tornAndStitched);
  return (
    <InSlices>
      <Prose text={words.intro} />
      <h3>{words.halves.title}</h3>
      <Prose text={words.halves.text} />
      <Figure
        figure={figure}
        pictures={['torn', 'net']}
        arrows={moves}
        sliders={['k', 'iterations']}
        caption={words.halves.caption}
      >
        <Energies figure={figure} />
      </Figure>
      <Question {...words.loops}>
        <WhatChanges words={words.loops} />
      </Question>
      <Question {...words.peanut}>
        <PeanutButter words={words.peanut} />
      </Question>
      <h3>{words.stop.title}</h3>
      <Prose text={words.stop.text} />
      <StoppingRules words={words.stop} />
      <Question
        {...words.enough}
        answer={fillTemplate(words.enough.answer, { tolerance: formatQuantity(tolerance, 'N', 1) })}
      >
        <EnoughRounds words={words.enough} />
      </Question>
      <Sources items={words.sources} />
    </InSlices>
  );
}
