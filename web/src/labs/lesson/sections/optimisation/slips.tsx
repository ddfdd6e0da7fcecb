import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import type { FigureSession } from '../../figures/figure_session.ts';
import { Slip } from '../../slip.tsx';
import { en } from './en.ts';
import { type PrintedSlip, printedSlips } from './printed_slips.ts';
import { zh } from './zh.ts';

/** Every slip that E has met in print, folded away until it is wanted. */
export function Slips({ figure }: { figure: FigureSession }) {
  return printedSlips.map((slip) => <FoldedSlip key={slip.id} figure={figure} slip={slip} />);
}

function FoldedSlip({
  figure,
  slip: { id, printed, right, printedEnergy },
}: {
  figure: FigureSession;
  slip: PrintedSlip;
}) {
  const { title, why } = inLanguage({ en, zh }).slips[id];
  const [open, setOpen] = useState(false);
  return (
    <details class="folded-slip" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{title}</summary>
      {open && <Slip figure={figure} printed={printed} right={right} why={why} printedEnergy={printedEnergy} />}
    </details>
  );
}
