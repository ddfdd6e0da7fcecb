import type { MatrixMeaning } from './model_of.ts';

/** For matrices whose pattern has entries that happen to be 0: grey, brown below, dark above. */
export const signKinds: NonNullable<MatrixMeaning['kinds']> = {
  of: (_, value) => 1 + Math.sign(value),
  colours: [['--sparsity-negative'], ['--muted'], ['--symbol-Q']],
};
