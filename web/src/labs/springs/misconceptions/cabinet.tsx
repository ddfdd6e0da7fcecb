import { inLanguage } from '../../../app/messages/in_language.ts';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { Phrase, Prose } from '../../../views/equations/prose.tsx';
import { type Card, cards } from './cards.ts';
import { en } from './en.ts';
import type { Order } from './experiment.ts';
import { ExperimentView } from './experiment_view.tsx';
import { ExplanationView } from './explanation_view.tsx';
import { score } from './score.ts';
import { zh } from './zh.ts';

const order: Order = ['right', 'wrong'];

interface Props {
  run: SideBySide;
  card: Card;
  onChoose: (card: Card) => void;
}

/** The ten mistakes; the one that is looked at runs beside the right solver. */
export function Cabinet({ run, card, onChoose }: Props) {
  const words = inLanguage({ en, zh });
  const text = words.cards[card.mistake];
  return (
    <div class="cabinet">
      <fieldset class="cabinet-list">
        <legend class="visually-hidden">{words.choose}</legend>
        {cards.map((one, at) => (
          <button
            key={one.mistake}
            type="button"
            aria-pressed={one === card}
            data-mistake={one.mistake}
            onClick={() => onChoose(one)}
          >
            <span class="cabinet-number">{at + 1}</span>
            <span class="cabinet-title">
              <Phrase text={words.cards[one.mistake].title} />
            </span>
            {score.value.known.includes(one.mistake) && (
              <span class="cabinet-known" title={words.known}>
                ✓<span class="visually-hidden"> {words.known}</span>
              </span>
            )}
          </button>
        ))}
      </fieldset>
      <article class="mistake" data-mistake={card.mistake}>
        <h3>
          <Phrase text={text.title} />
        </h3>
        <div class="mistake-symptom">
          <Prose text={text.symptom} />
        </div>
        <ExperimentView
          run={run}
          card={card}
          order={order}
          names={[words.stage.right, words.stage.wrong]}
          measure={card.measure}
          movesPins={card.movesPins ?? false}
        />
        <ExplanationView card={card} />
      </article>
    </div>
  );
}
