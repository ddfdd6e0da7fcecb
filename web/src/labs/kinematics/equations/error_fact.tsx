import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { errorAt, type Moment } from '../trace/moment.ts';
import { en } from './en.ts';
import { formatError } from './format_error.ts';
import { zh } from './zh.ts';

/** What the last event made of the distance between end effector and target. */
export function ErrorFact({ search, moment }: { search: Search; moment: Moment }) {
  const words = inLanguage({ en, zh });
  const [before, after] = [moment.before, moment.after].map((pose) => formatError(errorAt(search, pose)));
  return (
    <p class="equation-facts">
      <span>{fillTemplate(words.errorChange, { before, after })}</span>
    </p>
  );
}
