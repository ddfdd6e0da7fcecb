import type { MethodChoice } from '../../app/integrators.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { Prose } from '../../views/equations/prose.tsx';
import { en } from './en.ts';
import { entries, entryOf } from './entries.ts';
import { zh } from './zh.ts';

/** What the chosen methods do, and what they have in common. */
export function MethodCards({ methods }: { methods: readonly MethodChoice[] }) {
  const { cards, long } = inLanguage({ en, zh });
  const chosen = methods.map(entryOf);
  return (
    <section id="methods" class="method-cards" aria-labelledby="method-cards-heading">
      <h3 id="method-cards-heading">{cards.heading}</h3>
      <Prose text={cards.unifying} />
      <div class="method-cards-list">
        {entries
          .filter((entry) => chosen.includes(entry))
          .map((entry) => (
            <article key={entry}>
              <h4>{long[entry]}</h4>
              <Prose text={cards[entry]} />
            </article>
          ))}
      </div>
    </section>
  );
}
