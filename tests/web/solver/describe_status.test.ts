import { describe, expect, it } from 'vitest';
import { describeStatus } from '../../../web/src/solver/describe_status.ts';
import { statusCodes } from '../../../web/src/solver/module.ts';

describe('describeStatus', () => {
  it('names the field, its row where there is one, and the value', () => {
    expect(describeStatus({ code: 'index_out_of_range', field: 'E', index: 3, value: 12 })).toBe(
      'E[3]: there is no vertex 12',
    );
    expect(describeStatus({ code: 'index_out_of_range', field: 'half_step', index: -1, value: 99 })).toBe(
      'half_step: there is no half-step 99',
    );
    expect(describeStatus({ code: 'not_positive', field: 'k', index: -1, value: -5 })).toBe('k: -5 is not positive');
    expect(describeStatus({ code: 'no_scene', field: '', index: -1, value: 0 })).toBe('no scene has been set');
  });

  it.each(statusCodes)('fills every gap of its sentence for %s', (code) => {
    expect(describeStatus({ code, field: 'm', index: 0, value: Number.NaN })).toMatch(/^m\[0\]: [^{}]+$/);
  });
});
