import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import { highlightedSymbol } from '../../app/highlight.ts';
import { t } from '../../app/messages/index.ts';
import { symbolCommand } from '../../notation/macros.ts';
import type { SymbolId } from '../../notation/symbols.ts';
import { Formula } from './formula.tsx';
import { pointedElement, pointingHandlers } from './pointing.ts';
import { SymbolCard } from './symbol_card.tsx';
import { SymbolLegend } from './symbol_legend.tsx';
import 'katex/dist/katex.min.css';
import '../../notation/colours.css';
import './equations.css';

interface Props {
  title: string;
  /** Each wraps as a whole on narrow screens. */
  formulas: readonly string[];
  symbols: readonly SymbolId[];
  known: readonly SymbolId[];
  unknown: SymbolId;
  /** Whether the cursor stands on this half-step. */
  active: boolean;
  /** What some of the symbols are at present. */
  values: Partial<Record<SymbolId, string>>;
  /** Why the numbers are not what the reader may expect at this place of the trace; null where they are. */
  note: string | null;
  children: ComponentChildren;
}

/** One half-step: what is known and unknown in it, its equation, the equation's symbols, and below them its numbers. */
export function EquationPanel({ title, formulas, symbols, known, unknown, active, values, note, children }: Props) {
  const panel = useRef<HTMLElement>(null);
  const anchor = pointedElement.value;
  const id = highlightedSymbol.value;

  return (
    <section ref={panel} class="equation" data-active={active} aria-label={title} {...pointingHandlers}>
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
          <SymbolLegend ids={symbols} />
          {note !== null && <p class="equation-note">{note}</p>}
        </div>
        <div class="equation-numbers">{children}</div>
      </div>
      {anchor && id && panel.current?.contains(anchor) && <SymbolCard id={id} anchor={anchor} value={values[id]} />}
    </section>
  );
}

function SymbolList({ ids }: { ids: readonly SymbolId[] }) {
  return <Formula tex={ids.map(symbolCommand).join(',')} />;
}
