import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { cards } from '../../../../../web/src/labs/springs/misconceptions/cards.ts';
import {
  answered,
  choiceCount,
  noScore,
  questionOn,
  readScore,
  shuffledCards,
} from '../../../../../web/src/labs/springs/misconceptions/quiz.ts';

/** Numbers in [0, 1) from a seed: a linear congruential generator, good enough to shuffle ten cards. */
function randomFrom(seed: number) {
  let state = seed;
  return () => {
    state = (1664525 * state + 1013904223) % 2 ** 32;
    return state / 2 ** 32;
  };
}
const randoms = fc.integer({ min: 0, max: 2 ** 32 - 1 }).map(randomFrom);
const someCard = fc.constantFrom(...cards);

describe('questions', () => {
  it('come in every order, each mistake once, none twice running', () => {
    fc.assert(
      fc.property(randoms, someCard, (random, { mistake }) => {
        const order = shuffledCards(random, mistake);
        expect(order[0].mistake).not.toBe(mistake);
        expect(new Set(order)).toEqual(new Set(cards));
        expect(order).toHaveLength(cards.length);
      }),
    );
  });

  it('offer four different answers, one of them right, and none that looks the same', () => {
    fc.assert(
      fc.property(randoms, someCard, (random, card) => {
        const { choices } = questionOn(card, random);
        expect(new Set(choices).size).toBe(choiceCount);
        expect(choices).toContain(card.mistake);
        const alike = choices.filter((choice) => choice === 'd-once' || choice === 'one-iteration');
        expect(alike.length).toBeLessThan(2);
      }),
    );
  });

  it('put the right answer and the wrong net anywhere', () => {
    const random = randomFrom(1);
    const asked = Array.from({ length: 200 }, () => questionOn(cards[0], random));
    expect(new Set(asked.map(({ choices }) => choices.indexOf(cards[0].mistake))).size).toBe(choiceCount);
    expect(new Set(asked.map(({ wrongNet }) => wrongNet)).size).toBe(2);
  });
});

describe('the score', () => {
  const question = questionOn(cards[2], randomFrom(7));
  const wrong = question.choices.find((choice) => choice !== question.card.mistake) as (typeof question.choices)[0];

  it('counts answers, and each recognised mistake once', () => {
    let score = answered(noScore, question, wrong);
    expect(score).toEqual({ asked: 1, right: 0, known: [] });
    for (const right of [1, 2]) {
      score = answered(score, question, question.card.mistake);
      expect(score).toEqual({ asked: right + 1, right, known: [question.card.mistake] });
    }
  });

  it('comes back from its text', () => {
    const score = { asked: 9, right: 4, known: ['d-once', 'stored-zeros'] as const };
    expect(readScore(JSON.stringify(score))).toEqual(score);
  });

  it.each([
    null,
    '',
    'null',
    '[]',
    '{"asked":1}',
    '{"asked":1,"right":2,"known":[]}',
    '{"asked":-1,"right":-1,"known":[]}',
    '{"asked":1,"right":1,"known":{}}',
  ])('is none where %j is kept', (text) => expect(readScore(text)).toBe(noScore));

  it('knows no mistakes that there are not', () => {
    expect(readScore('{"asked":1,"right":1,"known":["none","typo","d-once"]}').known).toEqual(['d-once']);
  });
});
