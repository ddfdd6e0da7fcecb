import { signal } from '@preact/signals';
import { noScore, readScore, type Score } from './quiz.ts';

const key = 'mass-spring-lab/misconceptions';

/** Of the quiz, in this browser. Where it keeps nothing for the page, the score lasts for this visit. */
export const score = signal<Score>(readScore(kept()));

export function keepScore(next: Score): void {
  score.value = next;
  try {
    if (next === noScore) localStorage.removeItem(key);
    else localStorage.setItem(key, JSON.stringify(next));
  } catch {
    // refused or full: nothing that the reader should be bothered with
  }
}

function kept(): string | null {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}
