import { type Colour, ivory, type Picture, paint, sand, slate, vermilion } from './picture.ts';

/** One repeat of the stripes, the same across and along. Threads are one pixel wide; repeats × threads is a multiple of 4, so that the seam closes. */
const stripes: [threads: number, colour: Colour][] = [
  [20, slate],
  [6, sand],
  [4, slate],
  [19, ivory],
  [2, vermilion],
  [19, ivory],
  [4, slate],
  [6, sand],
];
const repeatsAround = 12;
const repeatsDown = 6;

/** A twill: each thread passes over two and under two, one further in each row. */
export function wovenPicture(): Picture {
  const threads = stripes.flatMap(([count, colour]) => Array<Colour>(count).fill(colour));
  const thread = (position: number) => threads[Math.floor(position) % threads.length];
  const warpOnTop = (x: number, y: number) => (Math.floor(x) + Math.floor(y)) % 4 < 2;
  return paint(repeatsAround * threads.length, repeatsDown * threads.length, 1, (x, y) =>
    warpOnTop(x, y) ? thread(x) : thread(y),
  );
}
