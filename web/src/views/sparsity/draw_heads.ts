import { steps125 } from '../../lib/steps_125.ts';
import { fontOf, type Sparsity } from './types.ts';
import type { Area } from './viewport.ts';

/** CSS pixels between numbers at the edges. */
const leastApart = { row: 17, column: 34 };
const strides = steps125(1, 1e6);

/** The numbers of rows and columns along the edges, left of and above the origin: every one where there is room, else every second, fifth, tenth, … */
export function drawHeads(c: CanvasRenderingContext2D, { pattern, view, ink, head }: Sparsity, area: Area): void {
  c.font = fontOf(12 * ink.typeScale);
  c.fillStyle = ink.muted;
  c.textBaseline = 'middle';
  const heads = (
    axis: 'row' | 'column',
    first: number,
    count: number,
    length: number,
    write: (at: number, text: string) => void,
  ) => {
    const stride = strides.find((step) => step * view.scale >= leastApart[axis]) ?? Number(strides.at(-1));
    const end = Math.min(count, first + length / view.scale);
    for (let index = Math.max(0, Math.ceil(first / stride)) * stride; index < end; index += stride) {
      const at = (index + 0.5 - first) * view.scale;
      if (at >= 0 && at <= length) write(at, head(axis, index));
    }
  };
  const left = Math.max(0, -view.column * view.scale);
  const top = Math.max(0, -view.row * view.scale);
  c.textAlign = 'right';
  heads('row', view.row, pattern.rows, area.height, (at, text) => c.fillText(text, left - 9, at + 1));
  c.textAlign = 'center';
  heads('column', view.column, pattern.columns, area.width, (at, text) => c.fillText(text, at, top - 12));
}
