import { useMemo, useRef, useState } from 'preact/hooks';
import { inLanguage } from '../../../app/messages/in_language.ts';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { Phrase, Prose } from '../../../views/equations/prose.tsx';
import { type Card, cards, type Shown } from './cards.ts';
import { en } from './en.ts';
import type { Order } from './experiment.ts';
import { ExperimentView } from './experiment_view.tsx';
import { answered, noScore, type Question, questionOn, shuffledCards } from './quiz.ts';
import { keepScore, score } from './score.ts';
import { zh } from './zh.ts';

interface Props {
  run: SideBySide;
  onRead: (card: Card) => void;
}

/** Two nets, one right, one not: which mistake is it? */
export function QuizView({ run, onRead }: Props) {
  const words = inLanguage({ en, zh });
  const [{ question, rest }, ask] = useState(() => next([], null));
  const [answer, setAnswer] = useState<Shown | null>(null);
  const { card, wrongNet, choices } = question;
  const order = useMemo((): Order => (wrongNet === 'A' ? ['wrong', 'right'] : ['right', 'wrong']), [wrongNet]);

  const asking = useRef<HTMLHeadingElement>(null);

  const choose = (choice: Shown) => {
    if (answer) return;
    setAnswer(choice);
    keepScore(answered(score.value, question, choice));
  };
  const goOn = () => {
    setAnswer(null);
    ask(next(rest, card.mistake));
    asking.current?.focus(); // the button that was pressed goes away
  };
  return (
    <article class="quiz" data-mistake={card.mistake}>
      <h3 ref={asking} tabIndex={-1}>
        {words.quiz.ask}
      </h3>
      <Score />
      <ExperimentView
        run={run}
        card={card}
        order={order}
        names={[fillTemplate(words.stage.net, { net: 'A' }), fillTemplate(words.stage.net, { net: 'B' })]}
        measure="height"
        movesPins={false}
        secret
      >
        <fieldset class="quiz-choices">
          <legend>{words.quiz.label}</legend>
          {choices.map((choice) => (
            <button
              key={choice}
              type="button"
              aria-disabled={answer !== null}
              class={answer === null ? '' : verdict(choice, answer, card.mistake)}
              data-choice={choice}
              onClick={() => choose(choice)}
            >
              <Phrase text={words.cards[choice].title} />
            </button>
          ))}
        </fieldset>
        <div role="status" class="quiz-answer">
          {answer && (
            <>
              <p>
                <strong>{answer === card.mistake ? words.quiz.rightAnswer : words.quiz.wrongAnswer}</strong>{' '}
                {fillTemplate(words.quiz.truth, { net: wrongNet })} <Phrase text={words.cards[card.mistake].title} />
              </p>
              <Prose text={words.cards[card.mistake].why} />
            </>
          )}
        </div>
        {answer && (
          <p class="quiz-next">
            <button type="button" class="quiz-go-on" onClick={goOn}>
              {words.quiz.next}
            </button>
            <button type="button" onClick={() => onRead(card)}>
              {words.quiz.read}
            </button>
          </p>
        )}
      </ExperimentView>
    </article>
  );
}

function Score() {
  const words = inLanguage({ en, zh }).quiz;
  const { asked, right, known } = score.value;
  return (
    <p class="quiz-score">
      {asked === 0 ? words.noScore : fillTemplate(words.score, { right, asked, known: known.length })} {words.kept}{' '}
      {asked > 0 && (
        <button type="button" onClick={() => keepScore(noScore)}>
          {words.forget}
        </button>
      )}
    </p>
  );
}

function next(rest: readonly Card[], last: Shown | null): { question: Question; rest: readonly Card[] } {
  const [first, ...others] = rest.length > 0 ? rest : shuffledCards(Math.random, last);
  return { question: questionOn(first ?? cards[0], Math.random), rest: others };
}

function verdict(choice: Shown, answer: Shown, truth: Shown): string {
  if (choice === truth) return 'is-right';
  return choice === answer ? 'is-wrong' : '';
}
