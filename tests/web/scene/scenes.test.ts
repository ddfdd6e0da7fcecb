import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { decode } from 'fast-png';
import { describe, expect, it } from 'vitest';
import type { Scene } from '../../../web/src/scene/scene.ts';
import { openScene } from '../../support/open_scene.ts';

/** #V, m: one coordinate of every vertex. */
const coordinates = ({ V }: Scene, axis: number) => V.filter((_, entry) => entry % 3 === axis);
const springs = ({ E }: Scene) => Array.from({ length: E.length / 2 }, (_, e) => [E[2 * e], E[2 * e + 1]]);

/** max_i Σ_j k Δt²/m_i, dimensionless. */
function stiffnessNumber(scene: Scene): number {
  const degree = new Float64Array(scene.m.length);
  for (const i of scene.E) degree[i]++;
  return Math.max(...degree.map((count, i) => (count * scene.k * scene.delta_t ** 2) / scene.m[i]));
}

/** How many vertices can be reached from vertex 0 along springs. */
function reachable(scene: Scene): number {
  const neighbours = Array.from(scene.m, (): number[] => []);
  for (const [i, j] of springs(scene)) {
    neighbours[i].push(j);
    neighbours[j].push(i);
  }
  const reached = new Set([0]);
  for (const i of reached) for (const j of neighbours[i]) reached.add(j); // a Set's iteration visits what is added during it
  return reached.size;
}

describe.each([
  { name: 'single-spring-horizontal', vertices: 2, springs: 1, pins: 1 },
  { name: 'triangle', vertices: 3, springs: 3, pins: 1 },
  { name: 'square', vertices: 4, springs: 4, pins: 2 },
  { name: 'horizontal-chain', vertices: 10, springs: 9, pins: 2 },
  { name: 'patch', vertices: 9, springs: 12, pins: 2 },
  { name: 'net', vertices: 61, springs: 120, pins: 6 },
  { name: 'tower', vertices: 209, springs: 768, pins: 16 },
  { name: 'flag', vertices: 81 * 41, springs: 80 * 41 + 81 * 40 + 80 * 40, pins: 41 },
  { name: 'skirt', vertices: 200 * 49, springs: 200 * 49 + 200 * 48 + 200 * 48, pins: 200 },
])('$name', ({ name, ...expected }) => {
  it('has the vertices, springs and pins that its rule says', async () => {
    const scene = await openScene(name);
    const found = { vertices: scene.m.length, springs: springs(scene).length, pins: scene.pinned.length };
    expect(found).toEqual(expected);
  });

  it('hangs together, no vertex on another, centred about the vertical axis', async () => {
    const scene = await openScene(name);
    const points = Array.from(scene.m, (_, i) => scene.V.slice(3 * i, 3 * i + 3).join(' '));
    expect(reachable(scene)).toBe(scene.m.length);
    expect(new Set(points).size).toBe(scene.m.length);
    for (const along of [coordinates(scene, 0), coordinates(scene, 2)]) {
      expect(Math.max(...along) + Math.min(...along)).toBeCloseTo(0, 1); // m: pleats and lattices need not mirror exactly
    }
  });

  it('is soft enough for the solver', async () => {
    expect(stiffnessNumber(await openScene(name))).toBeLessThan(1e9);
  });
});

describe('single-spring-horizontal', () => {
  it('is one metre long', async () => {
    const scene = await openScene('single-spring-horizontal');
    expect([...scene.V]).toEqual([-0.5, 0, 0, 0.5, 0, 0]);
    expect([...scene.pinned]).toEqual([0]);
  });
});

describe('horizontal-chain', () => {
  it('is pinned at both ends', async () => {
    expect([...(await openScene('horizontal-chain')).pinned]).toEqual([0, 9]);
  });
});

describe('net', () => {
  it('is pinned at six points of its rim, evenly', async () => {
    const scene = await openScene('net');
    const angles = Array.from(scene.pinned, (i) => Math.atan2(scene.V[3 * i + 2], scene.V[3 * i]));
    expect(angles.map((angle) => Math.round((angle * 180) / Math.PI + 360) % 360)).toEqual([0, 60, 120, 180, 240, 300]);
  });
});

describe('tower', () => {
  it('is pinned where it stands on the ground', async () => {
    const scene = await openScene('tower');
    const height = coordinates(scene, 1);
    expect([...scene.pinned]).toEqual([...height.keys()].filter((i) => height[i] === 0));
  });
});

describe.each([
  { name: 'flag', held: 'its left edge', axis: 0, end: Math.min },
  { name: 'skirt', held: 'its waist', axis: 1, end: Math.max },
])('$name', ({ name, held, axis, end }) => {
  it(`is pinned along ${held}, and nowhere else`, async () => {
    const scene = await openScene(name);
    const along = coordinates(scene, axis);
    const edge = end(...along);
    expect([...scene.pinned]).toEqual([...along.keys()].filter((i) => along[i] === edge));
  });

  it('has a small picture', async () => {
    const scene = await openScene(name);
    const picture = fileURLToPath(scene.texture?.url ?? '');
    expect(statSync(picture).size).toBeLessThan(60_000); // bytes
    expect(decode(readFileSync(picture)).channels).toBe(3);
    expect(Math.max(...(scene.texture?.VT ?? [2]))).toBeLessThanOrEqual(1);
  });

  it('turns the front of every triangle the same way: each inner edge runs once in each direction', async () => {
    const { F } = await openScene(name);
    const directed = new Set<string>();
    for (let f = 0; f < F.length; f += 3) {
      for (let c = 0; c < 3; c++) directed.add(`${F[f + c]} ${F[f + ((c + 1) % 3)]}`);
    }
    expect(directed.size).toBe(F.length);
  });
});

describe('scenes/generate.ts', () => {
  it('makes every file beside it, byte for byte', { timeout: 60_000 }, () => {
    const folder = mkdtempSync(join(tmpdir(), 'scenes-'));
    try {
      execFileSync(process.execPath, ['--import', 'tsx', 'scenes/generate.ts', folder]);
      const committed = readdirSync('scenes').filter((name) => /\.(json|obj|png)$/.test(name));
      expect(readdirSync(folder)).toEqual(committed);
      for (const name of committed) {
        const same = readFileSync(join(folder, name)).equals(readFileSync(join('scenes', name)));
        expect(same, `${name}: run npx tsx scenes/generate.ts`).toBe(true);
      }
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
});
