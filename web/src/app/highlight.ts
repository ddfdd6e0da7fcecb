import { signal } from '@preact/signals';
import type { SymbolId } from '../notation/symbols.ts';

/** The symbol the reader points at: every view marks all its occurrences. */
export const highlightedSymbol = signal<SymbolId | null>(null);
