import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** A joint in words: the first and the last say what they are. */
export function jointName(joint: number, joints: number): string {
  const words = inLanguage({ en, zh });
  const name = joint === 0 ? words.root : joint === joints - 1 ? words.effector : words.joint;
  return fillTemplate(name, { joint });
}
