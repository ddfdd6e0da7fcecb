import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { en } from './en.ts';
import type { Moment } from './moment.ts';
import { zh } from './zh.ts';

/** A place of the cursor in words: "iteration 3 of 12 · joint 2 turned". */
export function momentText({ answer }: Search, { kind, iteration, joint }: Moment): string {
  const words = inLanguage({ en, zh });
  const happened = fillTemplate(words.happened[kind], { joint: joint ?? '' });
  if (iteration === 0) return happened;
  return `${fillTemplate(words.iteration, { iteration, iterations: answer.iterations })} · ${happened}`;
}
