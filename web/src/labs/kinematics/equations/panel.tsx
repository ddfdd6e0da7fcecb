import type { ComponentChildren } from 'preact';
import { Formula } from '../../../views/equations/formula.tsx';
import { SymbolLegend } from '../../../views/equations/symbol_legend.tsx';

interface Props {
  heading: string;
  /** Beside the heading: which moment this is about. */
  moment?: string;
  /** Lines of formulas; each formula wraps as a whole. Those of the step just made are marked. */
  lines: readonly { formulas: readonly string[]; label?: string; active?: boolean }[];
  /** In place of numbers, where there are none. */
  note?: string | null;
  children?: ComponentChildren;
}

/** Formulas, a button for each of their symbols, and their numbers. */
export function Panel({ heading, moment, lines, note = null, children }: Props) {
  return (
    <section class="equation arm-equation" aria-label={heading}>
      <div class="arm-equation-heading">
        <h3>{heading}</h3>
        {moment && <p>{moment}</p>}
      </div>
      <div class="arm-formulas">
        {lines.map(({ formulas, label, active = false }) => (
          <div key={formulas[0]} class="equation-formulas" data-active={active}>
            {label && <span class="arm-formula-label">{label}</span>}
            {formulas.map((tex) => (
              <Formula key={tex} tex={tex} display />
            ))}
          </div>
        ))}
      </div>
      <SymbolLegend formulas={lines.flatMap(({ formulas }) => formulas)} />
      {note !== null && <p class="arm-note">{note}</p>}
      {children}
    </section>
  );
}
