import { expect, it } from 'vitest';
import { refusalParams } from '../../../web/src/app/refusal_params.ts';

it('what is too large is told in megabytes, beside the most there may be', () => {
  expect(refusalParams({ code: 'too_large', field: 'factor', index: -1, value: 127_244_560, limit: 120e6 })).toEqual({
    field: 'factor',
    index: -1,
    value: '127.2\u202fMB',
    limit: '120.0\u202fMB',
  });
});

it('what has no limit is told as it is', () => {
  const status = { code: 'not_positive', field: 'k', index: -1, value: -5, limit: 0 } as const;
  expect(refusalParams(status)).toEqual({ field: 'k', index: -1, value: -5 });
});
