import { type SymbolId, symbolIds, symbols } from './symbols.ts';

/** The TeX command that writes a symbol: \symp for p, \symdeltaT for Δt. */
export function symbolCommand(id: SymbolId): string {
  return `\\sym${id}`;
}

/** TeX command → the symbol inside a hook, so that every occurrence carries its id: <span class="sym" data-sym="d">. */
export const symbolMacros: Readonly<Record<string, string>> = Object.fromEntries(
  symbolIds.map((id) => [symbolCommand(id), `\\htmlClass{sym}{\\htmlData{sym=${id}}{${symbols[id].tex}}}`]),
);
