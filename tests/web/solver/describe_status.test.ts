import { describe, expect, it } from 'vitest';
import { describeStatus } from '../../../web/src/solver/describe_status.ts';
import { statusCodes } from '../../../web/src/solver/module.ts';

describe('describeStatus', () => {
  it('names the field, its row where there is one, and the value', () => {
    expect(describeStatus({ code: 'index_out_of_range', field: 'E', index: 3, value: 12, limit: 0 })).toBe(
      'E[3]: there is no vertex 12',
    );
    expect(describeStatus({ code: 'index_out_of_range', field: 'half_step', index: -1, value: 99, limit: 0 })).toBe(
      'half_step: there is no half-step 99',
    );
    expect(describeStatus({ code: 'not_positive', field: 'k', index: -1, value: -5, limit: 0 })).toBe(
      'k: -5 is not positive',
    );
    expect(describeStatus({ code: 'no_scene', field: '', index: -1, value: 0, limit: 0 })).toBe(
      'no scene has been set',
    );
  });

  it('names the limit of what is too large', () => {
    expect(describeStatus({ code: 'too_large', field: 'factor', index: -1, value: 2e8, limit: 1e8 })).toBe(
      'factor: 200000000 bytes are more than the 100000000 that the solver takes',
    );
  });

  it.each(statusCodes)('fills every gap of its sentence for %s', (code) => {
    expect(describeStatus({ code, field: 'm', index: 0, value: Number.NaN, limit: 0 })).toMatch(/^m\[0\]: [^{}]+$/);
  });
});
