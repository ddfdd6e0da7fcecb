import { isSymbolId, type SymbolId } from '../../notation/symbols.ts';

/** The symbols that formulas are made of, each once, in the order in which they are read. */
export function symbolsIn(formulas: readonly string[]): SymbolId[] {
  const commands = [...formulas.join(' ').matchAll(/\\sym([A-Za-z]+)/g)];
  return [...new Set(commands.map(([, id]) => id))].filter(isSymbolId);
}
