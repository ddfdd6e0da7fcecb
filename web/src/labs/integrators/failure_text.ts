import { inLanguage } from '../../app/messages/in_language.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatNumber } from '../../lib/format.ts';
import { describeStatus } from '../../solver/describe_status.ts';
import type { VariantState } from '../../solver/side_by_side.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** Why a method stands still, in a sentence or two. */
export function failureText(name: string, { status, step }: NonNullable<VariantState['failure']>): string {
  const words = inLanguage({ en, zh }).note;
  if (status.code === 'unstable')
    return fillTemplate(status.limit > 0 ? words.unstable : words.unbounded, {
      name,
      step,
      value: formatNumber(status.value),
      limit: formatNumber(status.limit),
    });
  if (status.code === 'diverged') return fillTemplate(words.grew, { name, step });
  return fillTemplate(words.failed, { step, sentence: describeStatus(status) });
}
