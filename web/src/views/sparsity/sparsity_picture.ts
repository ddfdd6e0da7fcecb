import { drawCells } from './draw_cells.ts';
import { drawHeads } from './draw_heads.ts';
import { drawBands, drawBoxes, drawWedges } from './draw_marks.ts';
import { drawTiles } from './draw_tiles.ts';
import { margin, type Sparsity } from './types.ts';
import type { Area } from './viewport.ts';

/** CSS pixels a cell from which entries are drawn one by one. */
const scaleOfCells = 8;
/** More device pixels than this in a CSS pixel cost without being seen. */
const mostPixelRatio = 2;

/** One sparse matrix on a canvas: tiles, darker with more entries, where a cell is under a pixel; else its cells, with numbers where they fit. */
export class SparsityPicture {
  private readonly canvas: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d') as CanvasRenderingContext2D;
  }

  /** `area`: CSS pixels of the matrix, without its heads. */
  render(shown: Sparsity, area: Area): void {
    const { context: c } = this;
    const ratio = Math.min(mostPixelRatio, window.devicePixelRatio);
    this.followSize(area, ratio);
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = shown.ink.background;
    c.fillRect(0, 0, area.width + margin.left + margin.right, area.height + margin.top + margin.bottom);
    c.translate(margin.left, margin.top);
    drawHeads(c, shown, area);
    drawWedges(c, shown, area);
    c.save();
    c.beginPath();
    c.rect(-1, -1, area.width + 2, area.height + 2); // with the frame's line
    c.clip();
    drawBands(c, shown);
    const part = { ...shown.view, rows: area.height / shown.view.scale, columns: area.width / shown.view.scale };
    if (shown.view.scale < scaleOfCells) drawTiles(c, shown, part, ratio);
    else drawCells(c, shown, part);
    this.drawFrame(shown);
    drawBoxes(c, shown);
    c.restore();
  }

  private followSize({ width, height }: Area, ratio: number): void {
    const wide = Math.round((width + margin.left + margin.right) * ratio);
    const high = Math.round((height + margin.top + margin.bottom) * ratio);
    if (this.canvas.width === wide && this.canvas.height === high) return;
    this.canvas.width = wide;
    this.canvas.height = high;
  }

  private drawFrame({ pattern, view: { scale, row, column }, ink }: Sparsity): void {
    this.context.strokeStyle = ink.muted;
    this.context.lineWidth = 1;
    this.context.strokeRect(
      -column * scale - 0.5,
      -row * scale - 0.5,
      pattern.columns * scale + 1,
      pattern.rows * scale + 1,
    );
  }
}
