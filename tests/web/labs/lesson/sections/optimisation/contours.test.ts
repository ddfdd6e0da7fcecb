import { describe, expect, it } from 'vitest';
import { contour, type Grid, levels } from '../../../../../../web/src/labs/lesson/sections/optimisation/contours.ts';

function grid(columns: number, rows: number, height: (x: number, y: number) => number): Grid {
  const values = Float64Array.from({ length: columns * rows }, (_, at) =>
    height(at % columns, Math.floor(at / columns)),
  );
  return { columns, rows, values };
}

describe('contour', () => {
  it('of a plane is exact: the line itself, once across each cell', () => {
    const segments = contour(
      grid(4, 3, (x, y) => x + 2 * y),
      3.5,
    );
    expect(segments).toHaveLength(4); // x + 2y = 3.5 leaves the grid at (3, ¼) and (0, 1¾), through 3 columns and 2 rows
    for (const [x, y] of segments.flat()) expect(x + 2 * y).toBeCloseTo(3.5, 12);
  });

  it('of a bowl closes: every end belongs to two lines', () => {
    const ends = contour(
      grid(20, 20, (x, y) => (x - 9.3) ** 2 + (y - 9.7) ** 2),
      30,
    ).flat();
    const met = new Map<string, number>();
    for (const end of ends) {
      const place = end.map((coordinate) => coordinate.toFixed(9)).join(' ');
      met.set(place, (met.get(place) ?? 0) + 1);
    }
    expect(met.size).toBeGreaterThan(20);
    expect([...met.values()].every((times) => times === 2)).toBe(true);
  });

  it('parts the corners of a saddle', () => {
    const saddle = { columns: 2, rows: 2, values: Float64Array.of(1, 0, 0, 1) };
    expect(contour(saddle, 0.5)).toHaveLength(2);
  });

  it('is empty where no value lies on the other side', () => {
    expect(
      contour(
        grid(3, 3, () => 1),
        1,
      ),
    ).toEqual([]);
  });
});

it('levels lie between the least and the greatest value, closer together below', () => {
  const values = Float64Array.of(10, 2, 18);
  expect(levels(values, 3, 1)).toEqual([6, 10, 14]);
  expect(levels(values, 3, 2)).toEqual([3, 6, 11]);
});
