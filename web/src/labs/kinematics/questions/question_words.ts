import { inLanguage } from '../../../app/messages/in_language.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** The texts of the lab's questions. */
export function questionWords() {
  return inLanguage({ en, zh });
}
