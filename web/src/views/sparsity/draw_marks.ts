import type { Place } from './pattern.ts';
import type { Sparsity } from './types.ts';
import type { Area } from './viewport.ts';

/** CSS pixels: what is marked is seen even where its row is a hundredth of one. */
const thinnestBand = 3;
const smallestBox = 7;
const wedge = { from: 1, to: 7, half: 4 };
const bandAlpha = '30'; // of ff

/** Below the entries: rows and columns that are pointed at, here or elsewhere, as bands. */
export function drawBands(c: CanvasRenderingContext2D, { pattern, view, marks, ink }: Sparsity): void {
  const { scale } = view;
  const left = -view.column * scale;
  const top = -view.row * scale;
  const thick = Math.max(scale, thinnestBand);
  c.fillStyle = ink.accent + bandAlpha;
  for (const row of marks.rows) c.fillRect(left, top + (row + 0.5) * scale - thick / 2, pattern.columns * scale, thick);
  for (const column of marks.columns)
    c.fillRect(left + (column + 0.5) * scale - thick / 2, top, thick, pattern.rows * scale);
}

/** At the edges, outside: a wedge points at every band. */
export function drawWedges(c: CanvasRenderingContext2D, { view, marks, ink }: Sparsity, area: Area): void {
  c.fillStyle = ink.accent;
  const left = Math.max(0, -view.column * view.scale);
  const top = Math.max(0, -view.row * view.scale);
  for (const row of marks.rows) {
    const y = (row + 0.5 - view.row) * view.scale;
    if (y >= 0 && y <= area.height)
      fillTriangle(c, [left - wedge.from, y], [left - wedge.to, y - wedge.half], [left - wedge.to, y + wedge.half]);
  }
  for (const column of marks.columns) {
    const x = (column + 0.5 - view.column) * view.scale;
    if (x >= 0 && x <= area.width)
      fillTriangle(c, [x, top - wedge.from], [x - wedge.half, top - wedge.to], [x + wedge.half, top - wedge.to]);
  }
}

/** Above the entries: single places, and the one where the keyboard stands. */
export function drawBoxes(c: CanvasRenderingContext2D, { view, marks, focus, ink }: Sparsity): void {
  const box = ({ row, column }: Place, width: number) => {
    const side = Math.max(view.scale, smallestBox);
    c.lineWidth = width;
    c.strokeRect(
      (column + 0.5 - view.column) * view.scale - side / 2,
      (row + 0.5 - view.row) * view.scale - side / 2,
      side,
      side,
    );
  };
  c.strokeStyle = ink.accent;
  for (const place of marks.places) box(place, 2);
  c.strokeStyle = ink.text;
  if (focus) box(focus, 2.5);
}

type Corner = readonly [x: number, y: number];

function fillTriangle(c: CanvasRenderingContext2D, ...corners: readonly [Corner, Corner, Corner]): void {
  c.beginPath();
  for (const [x, y] of corners) c.lineTo(x, y);
  c.fill();
}
