import { type Card, cards, type Shown } from './cards.ts';

export interface Question {
  card: Card;
  /** Which of the two nets makes the mistake. */
  wrongNet: 'A' | 'B';
  /** Four, the right one among them. */
  choices: readonly Shown[];
}

export const choiceCount = 4;

/** Mistakes that nobody can tell apart by looking, since they make the same positions: one of them at most is offered. */
const alike: readonly Shown[] = ['d-once', 'one-iteration'];

/** In [0, 1), as Math.random. */
export type Random = () => number;

/** The mistakes in the order in which they are asked for: each once before any comes again, and never one twice running. */
export function shuffledCards(random: Random, last: Shown | null = null): Card[] {
  const order = shuffled(cards, random);
  return order[0].mistake === last ? [...order.slice(1), order[0]] : order;
}

export function questionOn(card: Card, random: Random): Question {
  const offered: Shown[] = [card.mistake];
  for (const { mistake } of shuffled(cards, random)) {
    const isAlike = alike.includes(mistake) && offered.some((other) => alike.includes(other));
    if (offered.length < choiceCount && !offered.includes(mistake) && !isAlike) offered.push(mistake);
  }
  return {
    card,
    wrongNet: random() < 0.5 ? 'A' : 'B',
    choices: shuffled(offered, random),
  };
}

export interface Score {
  asked: number;
  right: number;
  /** What was answered rightly at least once. */
  known: readonly Shown[];
}

export const noScore: Score = { asked: 0, right: 0, known: [] };

export function answered({ asked, right, known }: Score, { card }: Question, choice: Shown): Score {
  if (choice !== card.mistake) return { asked: asked + 1, right, known };
  return { asked: asked + 1, right: right + 1, known: known.includes(choice) ? known : [...known, choice] };
}

/** What was kept as text, if that is a score at all: anybody can write into a browser's storage. */
export function readScore(text: string | null): Score {
  try {
    const { asked, right, known } = JSON.parse(text ?? '') as Record<keyof Score, unknown>;
    if (!isCount(asked) || !isCount(right) || right > asked || !Array.isArray(known)) return noScore;
    return { asked, right, known: cards.map(({ mistake }) => mistake).filter((mistake) => known.includes(mistake)) };
  } catch {
    return noScore;
  }
}

function isCount(value: unknown): value is number {
  return Number.isSafeInteger(value) && (value as number) >= 0;
}

/** By Fisher and Yates: every order is as likely as any other. */
function shuffled<T>(items: readonly T[], random: Random): T[] {
  const order = [...items];
  for (let end = order.length - 1; end > 0; end--) {
    const at = Math.floor(random() * (end + 1));
    [order[at], order[end]] = [order[end], order[at]];
  }
  return order;
}
