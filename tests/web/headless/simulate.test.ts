import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

function simulate(...args: string[]): { stdout: string; stderr: string; status: number | null } {
  const command = ['--import', 'tsx', 'web/headless/simulate.ts', ...args];
  const { stdout, stderr, status } = spawnSync(process.execPath, command, { encoding: 'utf8' });
  return { stdout, stderr, status };
}

const startsProcesses = { timeout: 60_000 }; // ms: a busy machine starts them slowly

describe('simulate', startsProcesses, () => {
  it('prints one JSON object: what was run, where it ended, what it cost', () => {
    const { stdout, stderr, status } = simulate('scenes/net.json', '--steps', '3', '--iterations', '5', '--dt', '0.02');
    expect([stderr, status]).toEqual(['', 0]);
    const { positions, velocities, objective, energy, iterationsMade, stopReason, milliseconds, ...run } =
      JSON.parse(stdout);
    expect(run).toEqual({
      scene: 'net',
      vertexCount: 61,
      springCount: 120,
      method: 'local-global',
      path: 'fast',
      storage: 'sparse',
      steps: 3,
      substeps: 1,
      iterations: 5,
      deltaT: 0.02,
      damping: 0,
    });
    expect(positions).toHaveLength(61);
    expect(velocities).toHaveLength(61);
    expect(energy).toHaveLength(3);
    expect(objective).toHaveLength(3);
    expect(iterationsMade).toEqual([5, 5, 5]);
    expect(stopReason).toEqual(['iterations', 'iterations', 'iterations']);
    expect(milliseconds).toEqual({
      precompute: expect.any(Number),
      step: { min: expect.any(Number), median: expect.any(Number) },
    });
  });

  it('takes the course’s other integrators, substeps and damping, and tells energies and velocities', () => {
    const { stdout } = simulate(
      ...['scenes/single-spring-horizontal.json', '--method', 'symplectic-euler', '--dt', '0.02', '--k', '100'],
      ...['--steps', '1', '--substeps', '2', '--damping', '3'],
    );
    const { positions, velocities, energy, method, substeps, damping } = JSON.parse(stdout);
    expect([method, substeps, damping]).toEqual(['symplectic-euler', 2, 3]);
    // Two steps of 0.01 s: first gravity alone, v = −0.098; then the level spring has turned, not stretched by more than 5e-7 m, and
    // resists with less than 1e-4 N: v = −0.196, y = −0.098·0.01 − 0.196·0.01.
    expect(positions[0]).toEqual([-0.5, 0, 0]);
    expect(positions[1][1]).toBeCloseTo(-2.94e-3, 6);
    expect(velocities[1][1]).toBeCloseTo(-0.196, 4);
    expect(energy).toHaveLength(1);
    const [x, y] = positions[1];
    expect(energy[0].gravity).toBeCloseTo(9.8 * y, 12);
    expect(energy[0].kinetic).toBeCloseTo((velocities[1][0] ** 2 + velocities[1][1] ** 2) / 2, 12);
    expect(energy[0].spring).toBeCloseTo(50 * (Math.hypot(x + 0.5, y) - 1) ** 2, 12);
  });

  it('says that a method left its stable region, and with which numbers', () => {
    const args = ['scenes/rabbit.json', '--method', 'symplectic-euler', '--steps', '1000'];
    const { stdout, stderr, status } = simulate(...args);
    expect(stderr).toMatch(/^rabbit\.json symplectic-euler: left its stable region: Δt·ω = \d\.\d+ > 2\n$/);
    expect([stdout, status]).toEqual(['', 2]);
  });

  it('takes one step of the single spring as by hand', () => {
    const { stdout } = simulate(
      'scenes/single-spring-horizontal.json',
      '--steps',
      '1',
      '--iterations',
      '1',
      '--k',
      '100',
    );
    const { positions, objective } = JSON.parse(stdout);
    // The spring lies level, so its projection asks for no height, and the second row of Q p = b is (k + m/Δt²) y = −m g with k = 100 N/m,
    // m = 1 kg, Δt = 1/30 s. The pin yields by about the reaction over w = 1e10 N/m: 1e-9 m, and so do all numbers here.
    const y = -9.8 / (100 + 900);
    expect(positions[1][0]).toBeCloseTo(0.5, 8);
    expect(positions[1][1]).toBeCloseTo(y, 8);
    expect(positions[1][2]).toBe(0);
    const potential = (100 / 2) * (Math.hypot(1, y) - 1) ** 2;
    const inertia = (900 / 2) * y ** 2;
    expect(objective[0]).toBeCloseTo(potential + inertia + 9.8 * y, 7);
  });

  it('takes a step by any method, and no longer than asked for', () => {
    const runs = ['local-global', 'lbfgs', 'newton'].map((method) => {
      const until = ['--iterations', '500', '--until-gradient', '1e-3'];
      return JSON.parse(simulate('scenes/net.json', '--steps', '2', '--method', method, ...until).stdout);
    });
    for (const { method, stopReason } of runs)
      expect([method, ...stopReason]).toEqual([method, 'gradient', 'gradient']);
    const [plain, lbfgs, newton] = runs.map(({ iterationsMade }) => iterationsMade[1]);
    expect(lbfgs).toBeLessThan(plain);
    expect(newton).toBeLessThan(lbfgs);
    // Within 1e-3 N of equilibrium against m/Δt² = 0.5 · 900 N/m: 2e-6 m.
    for (const { positions } of runs) {
      for (const [i, point] of positions.entries()) {
        for (const [axis, x] of point.entries()) expect(Math.abs(x - runs[2].positions[i][axis])).toBeLessThan(1e-5);
      }
    }
  });

  it('ends at the same place in both storages and in both formats', () => {
    const [sparse, dense] = ['sparse', 'dense'].map((storage) => {
      const { stdout } = simulate('scenes/net.json', '--steps', '2', '--storage', storage);
      return JSON.parse(stdout).positions.flat() as number[];
    });
    // Positions of about 1 m, through matrices of condition number w Δt²/m = 2e7: 1e-9 leaves room for rounding in another order.
    for (const [entry, value] of sparse.entries()) expect(Math.abs(value - dense[entry])).toBeLessThan(1e-9);

    const rows = simulate('scenes/net.json', '--steps', '2', '--format', 'csv').stdout.trimEnd().split('\n');
    expect(rows[0]).toBe('vertex,x,y,z');
    const numbers = rows.slice(1).map((row) => row.split(',').map(Number));
    expect(numbers.map(([vertex]) => vertex)).toEqual(Array.from({ length: 61 }, (_, i) => i + 1));
    expect(numbers.flatMap(([, ...point]) => point)).toEqual(sparse);
  });

  it('prints its help', () => {
    const { stdout, stderr, status } = simulate('--help');
    expect(stdout).toContain('--storage sparse|dense');
    expect([stderr, status]).toEqual(['', 0]);
  });
});

describe('simulate, given what it cannot run', startsProcesses, () => {
  const folder = mkdtempSync(join(tmpdir(), 'simulate-'));
  const files = {
    'syntax.json': '{\n  "obj": "a.obj",\n  "b" [1]\n}',
    'field.json': '{"obj": "spring.obj", "b": [1], "k": "soft"}',
    'pin.json': '{"obj": "spring.obj", "b": [1, 12], "k": 1, "m": 1}',
    'lost.json': '{"obj": "lost.obj", "b": [1], "k": 1, "m": 1}',
    'broken.json': '{"obj": "broken.obj", "b": [1], "k": 1, "m": 1}',
    'broken.obj': 'v 0 0 0\nv 1 0 0\nf 1 12\n',
    'spring.obj': 'v 0 0 0\nv 1 0 0\nf 1 2\n',
  };
  beforeAll(() => {
    for (const [name, content] of Object.entries(files)) writeFileSync(join(folder, name), content);
  });
  afterAll(() => rmSync(folder, { recursive: true }));

  it.each([
    [['scenes/net.json', '--steps', 'many'], /^--steps: "many" is not a whole number from 1 on\n$/],
    [[join(folder, 'none.json')], /^none\.json: cannot read none\.json\n$/],
    [[join(folder, 'syntax.json')], /^syntax\.json line 3: column 7: not JSON from \[1\] on\n$/],
    [[join(folder, 'field.json')], /^field\.json k: "soft" is not a finite number\n$/],
    [[join(folder, 'pin.json')], /^pin\.json b\[1\]: vertex 12 of 2\n$/],
    [[join(folder, 'lost.json')], /^lost\.json obj: cannot read lost\.obj\n$/],
    [[join(folder, 'broken.json')], /^broken\.obj line 3: vertex 12 of 2\n$/],
    [['scenes/net.json', '--k', '1e12'], /^net\.json .*stiffness number.*\n$/],
    [['scenes/skirt.json', '--storage', 'dense'], /^skirt\.json .*bytes.*\n$/],
  ])('says so in one line, exit code 2: %j', (args, line) => {
    const { stdout, stderr, status } = simulate(...args);
    expect(stderr).toMatch(line);
    expect([stdout, status]).toEqual(['', 2]);
  });
});
