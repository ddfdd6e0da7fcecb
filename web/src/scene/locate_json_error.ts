// JSON's grammar: a string holds any character from the space on except " and \, which it escapes.
const string = /"(?:[ !#-[\]-\uffff]|\\(?:["\\/bfnrt]|u[\da-fA-F]{4}))*"/;
const number = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/;
const token = new RegExp(`[{}[\\],:]|${string.source}|${number.source}|true|false|null`, 'y');
const space = /[ \t\n\r]*/y;

/** What may stand at a place in a JSON text. */
type Expected = 'value' | 'value or ]' | 'key' | 'key or }' | ':' | ', or end';

/**
 * Offset of the token at which `text`, which JSON.parse has refused, stops being JSON; its length when it only ends too early.
 * Ours because not every engine's message names a place.
 */
export function locateJsonError(text: string): number {
  const open: ('{' | '[')[] = [];
  let expected: Expected = 'value';
  let offset = match(space, text, 0).length;
  while (offset < text.length) {
    const found = match(token, text, offset);
    const next = follow(expected, found, open);
    if (next === null) return offset;
    expected = next;
    offset += found.length;
    offset += match(space, text, offset).length;
  }
  return offset;
}

function match(pattern: RegExp, text: string, offset: number): string {
  pattern.lastIndex = offset;
  return pattern.exec(text)?.[0] ?? '';
}

/** What is expected after token `found`, or null when it may not stand here. Keeps `open`, the brackets around. */
function follow(expected: Expected, found: string, open: ('{' | '[')[]): Expected | null {
  switch (expected) {
    case ':':
      return found === ':' ? 'value' : null;
    case 'key':
    case 'key or }':
      if (found.startsWith('"')) return ':';
      return found === '}' && expected === 'key or }' ? close(open) : null;
    case ', or end':
      if (found === ',' && open.length > 0) return open.at(-1) === '{' ? 'key' : 'value';
      return (found === '}' && open.at(-1) === '{') || (found === ']' && open.at(-1) === '[') ? close(open) : null;
    default:
      if (found === ']' && expected === 'value or ]') return close(open);
      if (found === '' || '}],:'.includes(found)) return null;
      if (found !== '{' && found !== '[') return ', or end';
      open.push(found);
      return found === '{' ? 'key or }' : 'value or ]';
  }
}

function close(open: ('{' | '[')[]): Expected {
  open.pop();
  return ', or end';
}
