/** What running time steps from rest took, natively or in WebAssembly. */
export interface TimedRun {
  /** #V×3, m, row-major: positions at the end. */
  p: ArrayLike<number>;
  /** ms: matrices and factorisation. */
  precompute: number;
  /** ms: the same once more for another k, which leaves the zeros of L where they are. */
  refactorise: number;
  /** ms, each. */
  stepTimes: number[];
}
