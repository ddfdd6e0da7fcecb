import type { MethodChoice } from '../../app/integrators.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { en } from './en.ts';
import { countOf, entryOf } from './entries.ts';
import { zh } from './zh.ts';

/** Of each method chosen, in few words, no two alike. */
export function namesOf(methods: readonly MethodChoice[]): string[] {
  const words = inLanguage({ en, zh }).caption;
  const names = methods.map(nameOf);
  return names.map((name, at) => {
    const number = names.slice(0, at + 1).filter((other) => other === name).length;
    return number > 1 ? fillTemplate(words.again, { name, number }) : name;
  });
}

function nameOf(choice: MethodChoice): string {
  const words = inLanguage({ en, zh });
  const entry = entryOf(choice);
  const name = words.short[entry];
  const count = countOf(entry);
  if (count === 'iterations') return fillTemplate(words.caption.iterations, { name, count: choice.iterations });
  return choice.substeps > 1 ? fillTemplate(words.caption.substeps, { name, count: choice.substeps }) : name;
}
