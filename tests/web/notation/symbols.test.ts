import { describe, expect, it } from 'vitest';
import { en } from '../../../web/src/app/messages/en/index.ts';
import { zh } from '../../../web/src/app/messages/zh/index.ts';
import { symbolCommand, symbolMacros } from '../../../web/src/notation/macros.ts';
import { symbolStyle } from '../../../web/src/notation/symbol_style.ts';
import { isAbout, isSymbolId, symbol, symbolIds } from '../../../web/src/notation/symbols.ts';

describe('the symbol table', () => {
  it.each(symbolIds)('%s has a name and a one-sentence meaning in both languages', (id) => {
    for (const { symbols } of [en, zh]) {
      expect(symbols.name[id].length).toBeGreaterThan(0);
      expect(symbols.meaning[id]).toMatch(/[.。]$/);
      const { section } = symbol(id);
      if (section !== null) expect(symbols.section[section].length).toBeGreaterThan(0);
    }
  });

  it('has ids that TeX can use in command names', () => {
    for (const id of symbolIds) expect(symbolCommand(id)).toMatch(/^\\sym[A-Za-z]+$/);
  });

  it('has no two symbols written alike', () => {
    expect(new Set(symbolIds.map((id) => symbol(id).tex)).size).toBe(symbolIds.length);
  });

  it('knows its own ids only', () => {
    expect(isSymbolId('d')).toBe(true);
    expect(isSymbolId('toString')).toBe(false);
  });

  it('gives every symbol a macro that carries its id', () => {
    for (const id of symbolIds) expect(symbolMacros[symbolCommand(id)]).toContain(`\\htmlData{sym=${id}}`);
  });
});

describe('isAbout', () => {
  it('reads from the shape what rows and columns belong to', () => {
    expect(symbolIds.filter((id) => isAbout(id, 'spring'))).toEqual(['E', 'r', 'd', 'v', 'A']);
    expect(isAbout('A', 'vertex')).toBe(true);
    expect(isAbout('C', 'vertex')).toBe(true);
    expect(isAbout('k', 'vertex')).toBe(false);
  });
});

describe('symbolStyle', () => {
  it('colours every symbol and lights it where it is named', () => {
    for (const id of symbolIds) {
      expect(symbolStyle()).toContain(`[data-sym="${id}"] { color: var(${symbol(id).colour}); }`);
      expect(symbolStyle()).toContain(`[data-lit~="${id}"] [data-sym="${id}"]`);
    }
  });
});
