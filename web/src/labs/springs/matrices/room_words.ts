import { inLanguage } from '../../../app/messages/in_language.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** The texts of this room, which are not among those of the first load. */
export function roomWords() {
  return inLanguage({ en, zh });
}
