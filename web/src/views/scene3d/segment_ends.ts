import type { Glsl } from './glsl.ts';
import type { Table } from './table.ts';

// What tells Segments where its segments lie: each defines `void ends(int segment, out vec3 a, out vec3 b)`, metres.

/** From rows of `tails` to rows of `tips` (both #×3, metres): a row of `pairs` (#×2) says which. */
export function joining(pairs: Table, tails: Table, tips: Table): Glsl {
  return {
    uniforms: { pairs: pairs.uniform, tails: tails.uniform, tips: tips.uniform },
    code: /* glsl */ `
      uniform sampler2D pairs;
      uniform sampler2D tails;
      uniform sampler2D tips;

      void ends(int segment, out vec3 a, out vec3 b) {
        vec2 pair = row(pairs, segment).xy;
        a = row(tails, int(pair.x)).xyz;
        b = row(tips, int(pair.y)).xyz;
      }
    `,
  };
}

/** Pieces of springs as `writePieces` describes them (#E×4): each about the middle of its spring between two rows of `points` (#V×3, metres). */
export function torn(springs: Table, points: Table, pieces: Table): Glsl {
  return {
    uniforms: { springs: springs.uniform, points: points.uniform, pieces: pieces.uniform },
    code: /* glsl */ `
      uniform sampler2D springs;
      uniform sampler2D points;
      uniform sampler2D pieces;

      void ends(int segment, out vec3 a, out vec3 b) {
        vec2 spring = row(springs, segment).xy;
        vec3 middle = 0.5 * (row(points, int(spring.x)) + row(points, int(spring.y))).xyz;
        vec3 halfPiece = row(pieces, segment).xyz;
        a = middle + halfPiece;
        b = middle - halfPiece;
      }
    `,
  };
}
