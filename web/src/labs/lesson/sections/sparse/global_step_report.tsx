import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatLength, formatQuantity } from '../../../../lib/format.ts';
import { en } from './en.ts';
import { farthest, type GlobalStep } from './global_step_with.ts';
import { zh } from './zh.ts';

/** In words, where a global step with the matrix as it has been assembled leads, and where the right one would. */
export function GlobalStepReport({ step, right }: { step: GlobalStep; right: GlobalStep }) {
  const words = inLanguage({ en, zh }).report;
  return (
    <p class="report" role="status">
      {'pivot' in step
        ? fillTemplate(words.failed, { row: step.failedAt, pivot: formatQuantity(step.pivot, 'N/m') })
        : 'p' in right && fillTemplate(words.moved, { distance: formatLength(farthest(step.p, right.p)) })}
    </p>
  );
}
