import { expect, it } from 'vitest';
import { Table } from '../../../../web/src/views/scene3d/table.ts';

it('holds its rows one after the other, in lines of a texture, and has room for any number of them', () => {
  const table = new Table(3);
  for (const count of [0, 1, 1024, 1025, 2]) {
    const rows = Float64Array.from({ length: 3 * count }, (_, at) => at);
    table.set(rows);
    const { data, width, height } = table.uniform.value.image;
    expect([...(data as Float32Array).subarray(0, rows.length)]).toEqual([...rows]);
    expect(data).toHaveLength(3 * width * height);
    expect(width * height).toBeGreaterThanOrEqual(count);
  }
});

it('is sent again only when it was written', () => {
  const table = new Table(2);
  table.set([1, 2]);
  const { version } = table.uniform.value;
  table.write(1)[0] = 3;
  expect(table.uniform.value.version).toBe(version + 1);
});
