const lineWidth = 120;

/** JSON for people to read: a line for each field of an object, lists filled into lines. */
export function jsonText(value: unknown, indent = ''): string {
  const inner = `${indent}  `;
  if (Array.isArray(value)) {
    const items = value.map(inOneLine);
    const oneLine = `[${items.join(', ')}]`;
    return oneLine.length < lineWidth / 2 ? oneLine : `[\n${filled(items, inner)}\n${indent}]`;
  }
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const fields = Object.entries(value).map(([name, field]) => `${inner}"${name}": ${jsonText(field, inner)}`);
  return `{\n${fields.join(',\n')}\n${indent}}`;
}

function inOneLine(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(inOneLine).join(', ')}]`;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const fields = Object.entries(value).map(([name, field]) => `${JSON.stringify(name)}: ${inOneLine(field)}`);
  return `{ ${fields.join(', ')} }`;
}

/** Items with commas, as many a line as fit. */
function filled(items: string[], indent: string): string {
  const lines = [indent + items[0]];
  for (const item of items.slice(1)) {
    const last = lines.length - 1;
    const longer = `${lines[last]}, ${item}`;
    if (longer.length < lineWidth) {
      lines[last] = longer;
    } else {
      lines[last] += ',';
      lines.push(indent + item);
    }
  }
  return lines.join('\n');
}
