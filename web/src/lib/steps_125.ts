/** 1, 2, 5 times a power of ten, from `least` to `most` inclusive. */
export function steps125(least: number, most: number): number[] {
  const steps: number[] = [];
  for (let exponent = Math.round(Math.log10(least)); 10 ** exponent <= most; exponent++) {
    for (const digit of [1, 2, 5]) steps.push(Number(`${digit}e${exponent}`));
  }
  return steps.filter((step) => step >= least && step <= most);
}
