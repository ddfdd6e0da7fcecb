import { spread } from './spread.ts';

export interface LineEnd {
  /** Of which curve. */
  curve: number;
  text: string;
  /** px: where the line ends. */
  y: number;
}

interface Props {
  ends: readonly LineEnd[];
  /** px: where the texts begin, and between which heights they may stand. */
  x: number;
  top: number;
  bottom: number;
}

const lineHeight = 16; // px
const letterWidth = 9; // px: of the widest, on average

/** What stands at the ends of lines: beside each, or as near as the others let it. */
export function LineEnds({ ends, x, top, bottom }: Props) {
  const heights = spread(
    ends.map(({ y }) => y),
    lineHeight,
    [top + lineHeight / 2, bottom - lineHeight / 2],
  );
  return (
    <>
      {ends.map(({ curve, text }, at) => (
        <text key={curve} class={`curve curve-${curve}`} x={x} y={heights[at] + 5}>
          {text}
        </text>
      ))}
    </>
  );
}

/** px: the room that these texts need. */
export function widthOfEnds(texts: readonly string[]): number {
  return letterWidth * Math.max(0, ...texts.map((text) => text.length));
}
