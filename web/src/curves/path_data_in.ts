/** Path data, and where in the text it stands. */
export interface PathData {
  d: string;
  index: number;
}

/** The d attributes of the paths where `text` is markup; itself where it is path data. */
export function pathDataIn(text: string): PathData[] {
  if (!text.trimStart().startsWith('<')) return [{ d: text, index: 0 }];
  const attribute = /<path\b[^>]*?\sd\s*=\s*(["'])(.*?)\1/gis;
  return [...text.matchAll(attribute)].map((match) => {
    const d = match[2] as string;
    return { d, index: match.index + match[0].length - 1 - d.length };
  });
}
