import { inLanguage } from '../../../app/messages/in_language.ts';
import { t } from '../../../app/messages/index.ts';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { describeStatus } from '../../../solver/describe_status.ts';
import type { VariantState } from '../../../solver/side_by_side.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

interface Props {
  run: SideBySide;
  /** Which of the nets. */
  net: number;
}

/** Why a net stands still: which vertex, in which time step and half-step. Its place is there before, so that it is read out when it fills. */
export function Failure({ run, net }: Props) {
  const failure = run.states.value?.[net]?.failure;
  return (
    <span class="failure" role="status">
      {failure && sentence(failure)}
    </span>
  );
}

function sentence({ status, step, half_step }: NonNullable<VariantState['failure']>): string {
  const words = inLanguage({ en, zh }).failure;
  const { code, field, index, value } = status;
  if (code !== 'diverged' || field !== 'p' || half_step === null)
    return fillTemplate(words.other, { step, sentence: describeStatus(status) });
  return fillTemplate(Number.isFinite(value) ? words.tooFar : words.nonFinite, {
    vertex: index,
    value: Number.isFinite(value) ? formatNumber(value) : String(value),
    step,
    half: t('page.phase.global'),
    iteration: half_step / 2,
  });
}
