import { en } from './en.ts';
import { inLanguage } from './text.ts';
import { zh } from './zh.ts';

/** The texts of the lesson's frame; every section has its own beside it. */
export function lessonWords() {
  return inLanguage({ en, zh });
}
