import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatLength } from '../../../lib/format.ts';
import { norm, row, subtract } from '../../../lib/vector.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** How a search ended, in a sentence with its reason. */
export function outcomeText({ task, answer }: Search): string {
  const { outcomes } = inLanguage({ en, zh });
  switch (answer.outcome) {
    case 'CONVERGED':
      return outcomes.converged;
    case 'STALLED':
      if (task.bend_limits.length > 0) return outcomes.held;
      if (task.turn_limit < Math.PI) return outcomes.slowed;
      return task.precision === 'single' ? outcomes.rounded : outcomes.stalled;
    case 'UNREACHABLE': {
      const lengths = Array.from({ length: task.offsets.length / 3 }, (_, i) => norm(row(task.offsets, i)));
      const farthest = lengths.reduce((sum, length) => sum + length);
      const distance = norm(subtract(row(task.target, 0), row(task.root, 0)));
      return fillTemplate(distance > farthest ? outcomes.tooFar : outcomes.tooNear, {
        distance: formatLength(distance),
        farthest: formatLength(farthest),
        nearest: formatLength(2 * Math.max(...lengths) - farthest),
      });
    }
    case 'MAX_ITERATIONS':
      return fillTemplate(outcomes.notYet, { iterations: answer.iterations });
  }
}
