import { describe, expect, it } from 'vitest';
import { formulas } from '../../../../web/src/notation/formulas.ts';
import { symbolCommand } from '../../../../web/src/notation/macros.ts';
import { symbol, symbolIds } from '../../../../web/src/notation/symbols.ts';
import { renderTeX } from '../../../../web/src/views/equations/render_tex.ts';

const definitions = symbolIds.flatMap((id) => symbol(id).definition ?? []);

describe('renderTeX', () => {
  it.each(symbolIds)('writes %s with its hook, and MathML beside it', (id) => {
    const html = renderTeX(symbolCommand(id), false);
    expect(html).toContain(`data-sym="${id}"`);
    expect(html).toContain('<math');
  });

  it.each([...Object.values(formulas).flat(), ...definitions])('hooks every symbol of %s', (tex) => {
    const html = renderTeX(tex, true);
    for (const [, id] of tex.matchAll(/\\sym([A-Za-z]+)/g)) expect(html).toContain(`data-sym="${id}"`);
  });

  it('refuses what is not a formula instead of printing it in red', () => {
    expect(() => renderTeX('\\frac{1', false)).toThrow();
    expect(() => renderTeX('\\symunheardof', false)).toThrow();
  });

  it('trusts no other HTML', () => {
    expect(renderTeX('\\htmlClass{other}{x}', false)).not.toContain('class="enclosing other"');
    expect(renderTeX('\\htmlData{sym=unheardof}{x}', false)).not.toContain('data-sym="unheardof"');
    expect(renderTeX('\\href{https://example.org}{x}', false)).not.toContain('<a ');
  });
});
