import { inLanguage } from '../../../../app/messages/in_language.ts';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { InSlices } from '../../in_slices.tsx';
import { RoomLink } from '../../room_link.tsx';
import { Sources } from '../../sources.tsx';
import { BothSides } from './both_sides.tsx';
import { en } from './en.ts';
import { Laplacian } from './laplacian.tsx';
import { LiftedParabola } from './lifted_parabola.tsx';
import { PushColumns } from './push_columns.tsx';
import { QTerms } from './q_terms.tsx';
import { hanging, SpringsProduct } from './springs_product.tsx';
import { WhatChanged } from './what_changed.tsx';
import { zh } from './zh.ts';
import './matrices.css';

export function Matrices() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(hanging);
  const seen = useInspection(figure);
  return (
    <InSlices>
      <Prose text={words.intro} />
      <SpringsProduct figure={figure} seen={seen} caption={words.product.caption} />
      <h3>{words.trace.title}</h3>
      <Prose text={words.trace.springs} />
      <BothSides figure={figure} seen={seen} text={words.trace.check} />
      <Prose text={words.trace.inertia} />
      <h3>{words.collect.title}</h3>
      <Prose text={words.collect.text} />
      <QTerms words={words.collect} />
      <Question ask={words.constants.ask} hint={words.constants.hint} answer={words.constants.answer}>
        <LiftedParabola words={words.constants} />
      </Question>
      <Question ask={words.changes.ask} hint={words.changes.hint} answer={words.changes.answer}>
        <WhatChanged words={words.changes} />
      </Question>
      <Question ask={words.laplacian.ask} hint={words.laplacian.hint} answer={words.laplacian.answer}>
        <Laplacian caption={words.laplacian.caption} />
      </Question>
      <Question ask={words.columns.ask} hint={words.columns.hint} answer={words.columns.answer}>
        <PushColumns words={words.columns} />
      </Question>
      <RoomLink room="matrices" />
      <Sources items={words.sources} />
    </InSlices>
  );
}
