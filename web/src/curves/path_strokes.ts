import svgpath from 'svgpath';
import { bezierStroke, extentOf, type Piece } from './bezier_stroke.ts';
import type { Point2, Stroke } from './curve.ts';
import type { CurveReason } from './curve_problem.ts';

/** More would leave too few digits to the differences. */
const largestCoordinate = 1e9;
/** Of the size: the line that closes a circle of arcs is this short at most, and no line. */
const rounding = 1e-9;

type Mistake = { index: number; reason: CurveReason };

/** The strokes of SVG path data, which has y downwards, with y upwards; or what is wrong with it, and at which index. */
export function pathStrokes(d: string): Stroke[] | Mistake {
  // Its types leave out the field that says what is wrong.
  const path = svgpath(d) as ReturnType<typeof svgpath> & { err: string };
  const mistake = mistakeIn(d, path.err);
  if (mistake) return mistake;

  const subpaths: { pieces: Piece[]; closed: boolean }[] = [];
  let pieces: Piece[] = [];
  let start: Point2 = [0, 0];
  const finish = (closed: boolean) => {
    subpaths.push({ pieces, closed });
    pieces = [];
  };
  path
    .abs()
    .unshort()
    .unarc()
    .iterate((segment, _, penX, penY) => {
      const pen: Point2 = [penX, -penY];
      const [command] = segment;
      if (command === 'M') {
        finish(false);
        start = [segment[1], -segment[2]];
      } else if (command === 'Z' || command === 'z') {
        pieces.push([pen, start]);
        finish(true);
      } else pieces.push([pen, ...pointsOf(segment as Drawing, pen)]);
    });
  finish(false);

  const numbers = subpaths.flatMap((subpath) => subpath.pieces.flat(2));
  const size = numbers.reduce((largest, number) => Math.max(largest, Math.abs(number)), 0);
  return subpaths.flatMap(({ pieces, closed }) => {
    const drawn = pieces.filter((piece) => extentOf(piece) > rounding * size);
    return drawn.length > 0 ? [bezierStroke(drawn, closed)] : [];
  });
}

/** What abs, unshort and unarc leave of the segments that draw. */
type Drawing = ['H', number] | ['V', number] | ['L' | 'Q' | 'C', ...number[]];

function pointsOf(segment: Drawing, [penX, penY]: Point2): Point2[] {
  if (segment[0] === 'H') return [[segment[1], penY]];
  if (segment[0] === 'V') return [[penX, -segment[1]]];
  const [, ...numbers] = segment;
  return numbers.flatMap((x, i) => (i % 2 === 0 ? [[x, -(numbers[i + 1] as number)] as const] : []));
}

function mistakeIn(d: string, complaint: string): Mistake | null {
  const first = d.search(/\S/);
  if (!/m/i.test(d.charAt(first))) return { index: first, reason: { code: 'no_move_first', found: d.charAt(first) } };
  const catmullRom = d.search(/r/i); // the library reads these curves, browsers do not
  const place = /at pos (\d+)/.exec(complaint)?.[1];
  const index = Math.min(place ? Number(place) : d.length, catmullRom < 0 ? d.length : catmullRom);
  if (place || catmullRom >= 0)
    return index >= d.trimEnd().length
      ? { index: d.trimEnd().length, reason: { code: 'path_ends_early' } }
      : { index, reason: { code: 'not_path_data', found: String.fromCodePoint(d.codePointAt(index) as number) } };
  const number = /[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?/gi;
  for (const { 0: found, index } of d.matchAll(number))
    if (Math.abs(Number(found)) > largestCoordinate)
      return { index, reason: { code: 'too_large', found, maximum: largestCoordinate } };
  return null;
}
