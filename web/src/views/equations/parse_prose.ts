export type Span =
  | { kind: 'text' | 'code'; text: string }
  /** `after`: the punctuation that may not begin a line of its own. */
  | { kind: 'tex'; text: string; after: string }
  | { kind: 'strong'; spans: Span[] }
  /** `path`: the address's, without "#/". */
  | { kind: 'link'; text: string; path: string };

export type Block =
  | { kind: 'paragraph'; spans: Span[] }
  | { kind: 'list'; items: Span[][] }
  | { kind: 'display'; tex: string };

const marks =
  /\*\*([^*]+)\*\*|\$([^$]+)\$([.,;:!?)\u3001\u3002\uff01\uff09\uff0c\uff1a\uff1b\uff1f]*)|\|([^|]+)\||\[([^\]]+)\]\(([\w/]+)\)/g;

/** Full-width punctuation and Chinese characters: between two of them a line break in the source is no space. */
const wide = /[\u2014\u2018-\u201d\u2026\u3000-\u303f\u4e00-\u9fff\uff00-\uffef]/;

/**
 * The author's notation: paragraphs, lists of lines that begin with "- ", and displayed $$formulas$$ are parted by blank lines; inside a line
 * stand $formulas$, **what is important**, |code|, and links to [sections](time) of the lesson or [elsewhere](springs/convergence).
 */
export function parseProse(source: string): Block[] {
  return source
    .trim()
    .split(/\n\s*\n/)
    .map(parseBlock);
}

function parseBlock(source: string): Block {
  const block = source.trim();
  if (block.startsWith('$$')) return { kind: 'display', tex: block.replace(/^\$\$|\$\$$/g, '').trim() };
  if (!block.startsWith('- ')) return { kind: 'paragraph', spans: parseSpans(block) };
  return {
    kind: 'list',
    items: block
      .slice(2)
      .split(/\n\s*- /)
      .map(parseSpans),
  };
}

function parseSpans(source: string): Span[] {
  const text = source.replace(/(.)\s*\n\s*(.)/gu, (_, before: string, after: string) =>
    wide.test(before) && wide.test(after) ? before + after : `${before} ${after}`,
  );
  const spans: Span[] = [];
  let end = 0;
  for (const mark of text.matchAll(marks)) {
    const [whole, strong, tex, after, code, link, to] = mark;
    if (mark.index > end) spans.push({ kind: 'text', text: text.slice(end, mark.index) });
    if (strong !== undefined) spans.push({ kind: 'strong', spans: parseSpans(strong) });
    else if (tex !== undefined) spans.push({ kind: 'tex', text: tex, after });
    else if (code !== undefined) spans.push({ kind: 'code', text: code });
    else spans.push({ kind: 'link', text: link, path: to.includes('/') ? to : `lesson/${to}` });
    end = mark.index + whole.length;
  }
  if (end < text.length) spans.push({ kind: 'text', text: text.slice(end) });
  return spans;
}
