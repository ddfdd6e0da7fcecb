import { describe, expect, it } from 'vitest';
import { linesOf, type SourceFile, sourceFiles, symbolNamed } from '../../../../web/src/views/code/sources.ts';
import { tokenize } from '../../../../web/src/views/code/tokenize.ts';

/** Every symbol that a listing links, in the order of its first occurrence. */
function linked(file: SourceFile) {
  const names = linesOf(file)
    .flatMap(tokenize)
    .filter(({ kind }) => kind === 'name');
  return [...new Set(names.flatMap(({ text }) => symbolNamed(text, file) ?? []))];
}

describe.each(sourceFiles)('%s', (file) => {
  const lines = linesOf(file);

  it('is shown without includes and namespace', () => {
    expect(lines.length).toBeGreaterThan(1);
    expect(lines[0]).toMatch(/^\S/);
    for (const line of lines) expect(line).not.toMatch(/#include|namespace mass_spring/);
  });

  it('loses nothing on its way through the tokenizer', () => {
    for (const line of lines)
      expect(
        tokenize(line)
          .map(({ text }) => text)
          .join(''),
      ).toBe(line);
  });
});

it.each([
  ['local_step.cpp', ['E', 'r', 'p', 'd']],
  ['global_step.cpp', ['k', 'd', 'p', 'A', 'Q', 'b']],
  ['right_hand_side.cpp', ['A', 'k', 'd', 'b', 'y']],
  ['inertial_right_hand_side.cpp', ['M', 'C', 'y', 'pCurr', 'pPrev', 'deltaT', 'w', 'pTarget', 'fExt']],
  ['sparse_cholesky.cpp', ['Q', 'L', 'b', 'p', 'P']],
] as const)('%s links %j', (file, symbols) => expect(linked(file)).toEqual(symbols));
