import { describe, expect, it } from 'vitest';
import { readPath } from '../../../../web/src/app/route.ts';
import { sectionIds } from '../../../../web/src/notation/sections.ts';
import { type Block, parseProse, type Span } from '../../../../web/src/views/equations/parse_prose.ts';
import { renderTeX } from '../../../../web/src/views/equations/render_tex.ts';

type Texts = { [key: string]: string | Texts };

const english = import.meta.glob<Texts>('../../../../web/src/labs/**/en.ts', { eager: true, import: 'en' });
const chinese = import.meta.glob<Texts>('../../../../web/src/labs/**/zh.ts', { eager: true, import: 'zh' });

const catalogues = Object.entries(english).map(([path, en]) => ({
  name: path.split('/').at(-2),
  en: new Map(flatten(en)),
  zh: new Map(flatten(chinese[path.replace('en.ts', 'zh.ts')])),
}));

function flatten(texts: Texts, path = ''): [string, string][] {
  return Object.entries(texts).flatMap(([key, value]) =>
    typeof value === 'string' ? [[path + key, value] as [string, string]] : flatten(value, `${path}${key}.`),
  );
}

function spansOf(block: Block): Span[] {
  const spans = block.kind === 'paragraph' ? block.spans : block.kind === 'list' ? block.items.flat() : [];
  return spans.flatMap((span) => (span.kind === 'strong' ? span.spans : [span]));
}

/** Words inside a formula are the language's own. */
const withoutWords = (tex: string) => tex.replace(/\\text\{[^}]*\}/g, '');
const displays = (source: string) => parseProse(source).flatMap((block) => (block.kind === 'display' ? block.tex : []));
const placeholders = (source: string) => [...source.matchAll(/\{\{(\w+)\}\}/g)].map(([, name]) => name).sort();

describe.each(catalogues)('the texts of $name', ({ en, zh }) => {
  it('have the same keys in both languages, none of them empty', () => {
    expect([...zh.keys()]).toEqual([...en.keys()]);
    for (const [key, text] of [...en, ...zh]) expect(text.trim(), key).not.toBe('');
  });

  it('fill in the same values and display the same formulas in both languages', () => {
    for (const [key, text] of en) {
      expect(placeholders(zh.get(key) as string), key).toEqual(placeholders(text));
      expect(displays(zh.get(key) as string).map(withoutWords), key).toEqual(displays(text).map(withoutWords));
    }
  });

  it('write formulas that can be set, and link to pages that exist', () => {
    for (const [key, text] of [...en, ...zh]) {
      for (const tex of displays(text)) expect(() => renderTeX(tex, true), key).not.toThrow();
      for (const span of parseProse(text).flatMap(spansOf)) {
        if (span.kind === 'tex') expect(() => renderTeX(span.text, false), `${key}: ${span.text}`).not.toThrow();
        if (span.kind !== 'link') continue;
        const route = readPath(`#/${span.path}`);
        expect(route, `${key}: ${span.path}`).not.toBeNull();
        if (route?.page === 'lesson') expect(sectionIds, key).toContain(route.section);
      }
    }
  });
});
