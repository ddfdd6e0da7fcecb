import { describe, expect, it } from 'vitest';
import { Mean } from '../../../web/src/app/measurements.ts';

describe('Mean', () => {
  it('says the first value at once, then twice a second the mean since', () => {
    const mean = new Mean();
    expect(mean.value).toBeNull();
    mean.add(7, 1000);
    expect(mean.value).toBe(7);
    mean.add(1, 1100);
    mean.add(2, 1400);
    expect(mean.value).toBe(7);
    mean.add(6, 1500);
    expect(mean.value).toBe(3);
  });
});
