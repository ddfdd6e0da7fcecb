import { type CodeLine, highlighted, litThings } from '../../../app/highlight.ts';
import { t } from '../../../app/messages/index.ts';
import { symbolValue } from '../../../app/symbol_value.ts';
import { formulas } from '../../../notation/formulas.ts';
import { symbolCommand } from '../../../notation/macros.ts';
import type { SymbolId } from '../../../notation/symbols.ts';
import { Formula } from '../formula.tsx';
import { Facts } from './facts.tsx';

interface Props {
  line: CodeLine;
  symbols: readonly SymbolId[];
}

/** A line of code: what its function computes, and the symbols that meet in it with their present values. */
export function LineCard({ line: { file, number }, symbols }: Props) {
  const { figure } = highlighted.value;
  const selection = figure && litThings(figure);
  return (
    <>
      <p class="card-name">
        <code>{file}</code> <strong>{t('equations.card.line', { number })}</strong>
      </p>
      {formulasOf(file).map((tex) => (
        <p key={tex} class="card-definition">
          <Formula tex={tex} />
        </p>
      ))}
      <Facts
        facts={symbols.map((id) => [
          <Formula key={id} tex={symbolCommand(id)} />,
          <>
            {t(`symbols.name.${id}`)} <span>{selection && symbolValue(id, figure, selection)}</span>
          </>,
        ])}
      />
    </>
  );
}

function formulasOf(file: string): readonly string[] {
  const name = file.replace(/\.\w+$/, '');
  return (formulas as Record<string, readonly string[]>)[name] ?? [];
}
