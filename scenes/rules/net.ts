import type { MadeScene, Point, Spring } from './made_scene.ts';

const threads = 12; // even, so that every other one ends at a pin
const rings = 5;
const radius = 1; // m

/** A spider's web, level, held by every other one of its radial threads. */
export function net(): MadeScene {
  const vertices: Point[] = [[0, 0, 0]];
  const springs: Spring[] = [];
  for (let ring = 1; ring <= rings; ring++) {
    for (let thread = 0; thread < threads; thread++) {
      const angle = (2 * Math.PI * thread) / threads;
      const r = (radius * ring) / rings;
      vertices.push([r * Math.cos(angle), 0, r * Math.sin(angle)]);
      springs.push([ring === 1 ? 0 : at(ring - 1, thread), at(ring, thread)], [at(ring, thread), at(ring, thread + 1)]);
    }
  }
  const pinned = Array.from({ length: threads / 2 }, (_, i) => at(rings, 2 * i));
  return { name: 'net', vertices, shape: { springs }, pinned, k: 300, m: 0.5 };
}

/** Index of the vertex where a ring, counted from 1, crosses a thread. */
function at(ring: number, thread: number): number {
  return 1 + (ring - 1) * threads + (thread % threads);
}
