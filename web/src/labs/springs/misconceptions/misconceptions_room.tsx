import { useEffect, useState } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { t } from '../../../app/messages/index.ts';
import { Choice } from '../../../lib/choice.tsx';
import { Prose } from '../../../views/equations/prose.tsx';
import { Cabinet } from './cabinet.tsx';
import { type Card, cards } from './cards.ts';
import { en } from './en.ts';
import { QuizView } from './quiz_view.tsx';
import { useRun } from './use_run.ts';
import { zh } from './zh.ts';
import './misconceptions.css';

/** Mistakes that students make, each made by a solver of its own beside the right one; and a quiz on them. */
export function MisconceptionsRoom({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh });
  const [mode, setMode] = useState<'cabinet' | 'quiz'>('cabinet');
  const [card, setCard] = useState<Card>(cards[0]);
  const run = useRun(actions);
  useEffect(() => {
    document.body.dataset.ready = 'true';
  }, []);
  const read = (one: Card) => {
    setCard(one);
    setMode('cabinet');
  };
  return (
    <main class="misconceptions">
      <header>
        <h2>{t('page.rooms.misconceptions')}</h2>
        <Choice
          label={words.modes.label}
          options={[
            ['cabinet', words.modes.cabinet],
            ['quiz', words.modes.quiz],
          ]}
          chosen={mode}
          onChoose={setMode}
        />
      </header>
      <Prose text={mode === 'cabinet' ? words.intro : words.quiz.intro} />
      {mode === 'cabinet' ? <Cabinet run={run} card={card} onChoose={setCard} /> : <QuizView run={run} onRead={read} />}
    </main>
  );
}
