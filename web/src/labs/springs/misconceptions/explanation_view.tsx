import { inLanguage } from '../../../app/messages/in_language.ts';
import { t } from '../../../app/messages/index.ts';
import { pathOf } from '../../../app/route.ts';
import { CodeListing } from '../../../views/code/code_listing.tsx';
import { linesMissingIn } from '../../../views/code/sources.ts';
import { Prose } from '../../../views/equations/prose.tsx';
import { WideFormula } from '../../../views/equations/wide_formula.tsx';
import type { Card } from './cards.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** Why the mistake does what it does, where it stands in formula and code, and what helps. */
export function ExplanationView({ card }: { card: Card }) {
  const words = inLanguage({ en, zh });
  const { parts } = words;
  const text = words.cards[card.mistake];
  const pairs = card.code.map(({ wrong, right }) => {
    return { wrong, right, inWrong: linesMissingIn(right, wrong), inRight: linesMissingIn(wrong, right) };
  });
  return (
    <div class="explanation">
      <section class="explanation-words">
        <h4>{parts.why}</h4>
        <Prose text={text.why} />
        <h4>{parts.fix}</h4>
        <Prose text={text.fix} />
        <p>
          {parts.section}{' '}
          <a href={pathOf({ page: 'lesson', section: card.section })}>{t(`symbols.section.${card.section}`)}</a>
        </p>
      </section>
      <section>
        <h4>{parts.formula}</h4>
        <dl class="wrong-and-right">
          <dt class="is-wrong">✗ {parts.wrong}</dt>
          <dd>
            <WideFormula tex={card.wrong} />
          </dd>
          <dt class="is-right">✓ {parts.right}</dt>
          <dd>
            <WideFormula tex={card.right} />
          </dd>
        </dl>
      </section>
      <section class="explanation-code">
        <h4>{parts.code}</h4>
        {pairs.some(({ inWrong, inRight }) => inWrong.size + inRight.size > 0) && <p>{parts.marked}</p>}
        {pairs.map(({ wrong, right, inWrong, inRight }) => (
          <div key={wrong.name} class="code-pair">
            <div>
              <p class="is-wrong">✗ {parts.wrong}</p>
              <CodeListing {...wrong} marked={inWrong} />
            </div>
            <div>
              <p class="is-right">✓ {parts.right}</p>
              <CodeListing {...right} marked={inRight} />
            </div>
          </div>
        ))}
      </section>
    </div>
  );
}
