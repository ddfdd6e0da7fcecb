import { useSignal, useSignalEffect } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { appliedTheme } from '../../app/preferences.ts';
import { drawTiles } from './draw_tiles.ts';
import { inkOf } from './ink_of.ts';
import type { SparsityModel } from './sparsity_view.tsx';
import { noMarks } from './types.ts';
import { fitted } from './viewport.ts';

const side = 48; // CSS pixels
const ratio = 2;

/** All of a matrix in a few pixels: a picture on a button. Empty as long as there is no matrix. */
export function SparsityThumb({ model }: { model: SparsityModel | null }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const shown = useSignal(model);
  shown.value = model;
  useSignalEffect(() => {
    void appliedTheme.value;
    const c = canvas.current?.getContext('2d');
    if (!c) return;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, side, side);
    if (!shown.value) return;
    const { pattern, kinds, write, head } = shown.value;
    const area = { width: side, height: side };
    const view = fitted(pattern, area);
    const ink = inkOf(kinds);
    const part = { ...view, rows: side / view.scale, columns: side / view.scale };
    drawTiles(c, { pattern, view, ink, marks: noMarks, focus: null, write, head }, part, ratio);
    c.strokeStyle = ink.line;
    c.strokeRect(
      -view.column * view.scale + 0.5,
      -view.row * view.scale + 0.5,
      pattern.columns * view.scale - 1,
      pattern.rows * view.scale - 1,
    );
  });
  return <canvas ref={canvas} class="sparsity-thumb" width={side * ratio} height={side * ratio} />;
}
