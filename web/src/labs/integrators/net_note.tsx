import { inLanguage } from '../../app/messages/in_language.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatQuantity } from '../../lib/format.ts';
import { en } from './en.ts';
import { energyRate } from './energies.ts';
import { failureText } from './failure_text.ts';
import { zh } from './zh.ts';

/** Under a net's name: what its energy does, or why it stands still. Only the latter is read out. */
export function NetNote({ run, net, name }: { run: SideBySide; net: number; name: string }) {
  run.moving.value; // whoever fails is told at once, and the energy as often as a reader can follow
  const failure = run.states.peek()?.[net]?.failure ?? null;
  return (
    <>
      {!failure && rateText(energyRate(run.energies.value[net] ?? []))}
      <span class="integrators-failure" role="status">
        {failure && failureText(name, failure)}
      </span>
    </>
  );
}

/** W: less is rounding, or a motion that nobody sees. */
const nothing = 1e-6;

export function rateText(rate: number | null): string {
  const words = inLanguage({ en, zh }).note;
  if (rate === null) return '';
  if (Math.abs(rate) < nothing) return words.keeps;
  return fillTemplate(rate < 0 ? words.loses : words.gains, { rate: formatQuantity(Math.abs(rate), 'J') });
}
