import type { ComponentChildren } from 'preact';
import { t } from '../../app/messages/index.ts';
import { symbolCommand } from '../../notation/macros.ts';
import type { SymbolId } from '../../notation/symbols.ts';
import { Formula } from './formula.tsx';
import { SymbolLegend } from './symbol_legend.tsx';

interface Props {
  title: string;
  /** Each wraps as a whole on narrow screens. */
  formulas: readonly string[];
  known: readonly SymbolId[];
  unknown: SymbolId;
  /** Whether the cursor stands on this half-step. */
  active: boolean;
  /** Why the numbers are not what the reader may expect at this place of the trace; null where they are. */
  note: string | null;
  children: ComponentChildren;
}

/** One half-step: what is known and unknown in it, its equation, the equation's symbols, and below them its numbers. */
export function EquationPanel({ title, formulas, known, unknown, active, note, children }: Props) {
  return (
    <section class="equation" data-active={active} aria-label={title}>
      <p class="equation-roles">
        <span>
          {t('equations.known')} <SymbolList ids={known} />
        </span>
        <span>
          {t('equations.unknown')} <SymbolList ids={[unknown]} />
        </span>
        {active && <strong class="equation-now">{t('equations.thisHalfStep')}</strong>}
      </p>
      <div class="equation-body">
        <div class="equation-writing">
          <div class="equation-formulas">
            {formulas.map((tex) => (
              <Formula key={tex} tex={tex} display />
            ))}
          </div>
          <SymbolLegend formulas={formulas} />
          {note !== null && <p class="equation-note">{note}</p>}
        </div>
        <div class="equation-numbers">{children}</div>
      </div>
    </section>
  );
}

function SymbolList({ ids }: { ids: readonly SymbolId[] }) {
  return <Formula tex={ids.map(symbolCommand).join(',')} />;
}
