import { inLanguage } from '../../app/messages/in_language.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** The texts of the lesson's frame; every section has its own beside it. */
export function lessonWords() {
  return inLanguage({ en, zh });
}
