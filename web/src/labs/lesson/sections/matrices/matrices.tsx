import { Prose } from '../../prose.tsx';
import { Question } from '../../question.tsx';
import { Sources } from '../../sources.tsx';
import { inLanguage } from '../../text.ts';
import { en } from './en.ts';
import { QTerms } from './q_terms.tsx';
import { SpringsProduct } from './springs_product.tsx';
import { WhatChanged } from './what_changed.tsx';
import { zh } from './zh.ts';
import './matrices.css';

export function Matrices() {
  const words = inLanguage({ en, zh });
  return (
    <>
      <Prose text={words.intro} />
      <SpringsProduct caption={words.product.caption} check={words.trace.check} />
      <h3>{words.trace.title}</h3>
      <Prose text={words.trace.text} />
      <h3>{words.collect.title}</h3>
      <Prose text={words.collect.text} />
      <QTerms words={words.collect} />
      <Question ask={words.changes.ask} hint={words.changes.hint} answer={words.changes.answer}>
        <WhatChanged words={words.changes} />
      </Question>
      <Question {...words.laplacian} />
      <Question {...words.columns} />
      <Sources items={words.sources} />
    </>
  );
}
