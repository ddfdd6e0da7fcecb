export interface Token {
  kind: 'comment' | 'number' | 'keyword' | 'name' | 'other';
  text: string;
}

/** Comments to the end of the line, numbers, words, and whatever lies between. The core has no comments of other kinds and no strings. */
const pattern = /(?<comment>\/\/.*)|(?<number>\d[\d.]*(?:e-?\d+)?)|(?<word>[A-Za-z_]\w*)|[^\w/]+|./g;

const keywords = new Set([
  'auto',
  'bool',
  'const',
  'constexpr',
  'double',
  'else',
  'false',
  'for',
  'if',
  'int',
  'namespace',
  'return',
  'static_cast',
  'template',
  'true',
  'typename',
  'void',
  'while',
]);

/** A line of C++ in pieces that put together are the line again. */
export function tokenize(line: string): Token[] {
  return [...line.matchAll(pattern)].map(({ 0: text, groups }) => ({ kind: kindOf({ ...groups }), text }));
}

function kindOf({ comment, number, word }: Record<string, string | undefined>): Token['kind'] {
  if (comment !== undefined) return 'comment';
  if (number !== undefined) return 'number';
  if (word === undefined) return 'other';
  return keywords.has(word) ? 'keyword' : 'name';
}
