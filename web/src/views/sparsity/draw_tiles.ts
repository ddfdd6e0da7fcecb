import { density, type Part, tileSize, tilesOf } from './tiles.ts';
import type { Sparsity } from './types.ts';

/** A pixel for every tile, to be enlarged onto the canvas. */
const pixelsOfTiles = document.createElement('canvas');

/** The entries of a part as tiles of at least one device pixel, of which there are `ratio` in a CSS pixel. */
export function drawTiles(
  c: CanvasRenderingContext2D,
  { pattern, view, ink }: Sparsity,
  part: Part,
  ratio: number,
): void {
  const tiles = tilesOf(pattern, tileSize(view.scale * ratio), part);
  if (tiles.rows === 0 || tiles.columns === 0) return;
  const image = new ImageData(tiles.columns, tiles.rows);
  const pixels = new Uint32Array(image.data.buffer);
  const colours = ink.kinds.map(([first]) => Number.parseInt(first.slice(1), 16));
  for (let tile = 0; tile < pixels.length; tile++) {
    const count = tiles.count[tile];
    if (count === 0) continue;
    const colour = colours[tiles.kind[tile]];
    const alpha = Math.round(255 * density(count, tiles.size));
    // In memory red, green, blue, alpha: the lowest byte first.
    pixels[tile] = (alpha << 24) | ((colour & 0xff) << 16) | (colour & 0xff00) | (colour >> 16);
  }
  pixelsOfTiles.width = tiles.columns;
  pixelsOfTiles.height = tiles.rows;
  pixelsOfTiles.getContext('2d')?.putImageData(image, 0, 0);
  const side = tiles.size * view.scale;
  c.imageSmoothingEnabled = tiles.size > 1; // single cells keep sharp edges
  c.drawImage(
    pixelsOfTiles,
    tiles.firstColumn * side - view.column * view.scale,
    tiles.firstRow * side - view.row * view.scale,
    tiles.columns * side,
    tiles.rows * side,
  );
}
