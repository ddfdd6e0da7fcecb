import { describe, expect, it } from 'vitest';
import { parseProse } from '../../../../web/src/views/equations/parse_prose.ts';

const { raw } = String;
const text = (words: string) => ({ kind: 'text', text: words });

describe('parseProse', () => {
  it('parts paragraphs, lists and displayed formulas at blank lines', () => {
    const source = `
      One,
      two.

      $$
      a = b
      $$

      - first
        goes on
      - second
    `;
    expect(parseProse(source)).toEqual([
      { kind: 'paragraph', spans: [text('One, two.')] },
      { kind: 'display', tex: 'a = b' },
      { kind: 'list', items: [[text('first goes on')], [text('second')]] },
    ]);
  });

  it('finds formulas, code, emphasis and links inside a line', () => {
    expect(parseProse(raw`Let $\symp_i$ be **the $i$-th row**, |p.row(i)|, as in [section 6](matrices).`)).toEqual([
      {
        kind: 'paragraph',
        spans: [
          text('Let '),
          { kind: 'tex', text: raw`\symp_i`, after: '' },
          text(' be '),
          { kind: 'strong', spans: [text('the '), { kind: 'tex', text: 'i', after: '' }, text('-th row')] },
          text(', '),
          { kind: 'code', text: 'p.row(i)' },
          text(', as in '),
          { kind: 'link', text: 'section 6', path: 'lesson/matrices' },
          text('.'),
        ],
      },
    ]);
  });

  it('keeps what may not begin a line with the formula before it', () => {
    expect(parseProse('位置是 $p$。质量是 $m$；')).toEqual([
      {
        kind: 'paragraph',
        spans: [
          text('位置是 '),
          { kind: 'tex', text: 'p', after: '。' },
          text('质量是 '),
          { kind: 'tex', text: 'm', after: '；' },
        ],
      },
    ]);
  });

  it('makes no space of a line break between Chinese characters, but one beside a formula', () => {
    expect(parseProse('质点的\n      位置是 $p$\n      。')).toEqual([
      { kind: 'paragraph', spans: [text('质点的位置是 '), { kind: 'tex', text: 'p', after: '' }, text(' 。')] },
    ]);
  });
});
