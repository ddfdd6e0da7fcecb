import type { MadeScene, Point, Spring } from '../../scenes/rules/made_scene.ts';

const beam = [20, 11, 11]; // cells along x, y, z: 21·12·12 = 3,024 vertices
const cell = 0.05; // m: the beam is 1 m by 0.55 m by 0.55 m

/** Of the six tetrahedra around the diagonal of a cube, every edge leads from a corner to one whose coordinates are larger by 0 or 1 each. */
const edges = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 1, 0],
  [1, 0, 1],
  [0, 1, 1],
  [1, 1, 1],
];

/** A beam, or another block, cut into tetrahedra, a spring along every edge, held by the face x = 0: L fills as that of a solid does, far more than cloth. */
export function tetrahedralBlock(cells = beam): MadeScene {
  const vertices: Point[] = [];
  const springs: Spring[] = [];
  const inside = (corner: number[]) => corner.every((coordinate, axis) => coordinate <= cells[axis]);
  const index = ([x, y, z]: number[]) => (x * (cells[1] + 1) + y) * (cells[2] + 1) + z;
  for (let x = 0; x <= cells[0]; x++) {
    for (let y = 0; y <= cells[1]; y++) {
      for (let z = 0; z <= cells[2]; z++) {
        vertices.push([x * cell, y * cell, z * cell]);
        for (const [dx, dy, dz] of edges) {
          const end = [x + dx, y + dy, z + dz];
          if (inside(end)) springs.push([index([x, y, z]), index(end)]);
        }
      }
    }
  }
  return {
    name: 'block',
    vertices,
    shape: { springs },
    pinned: Array.from({ length: index([1, 0, 0]) }, (_, i) => i),
    k: 2e4, // so soft that its free end sinks by some 10 cm
    m: 0.125, // 1,000 kg/m³
  };
}
