import { describe, expect, it } from 'vitest';
import {
  linesMissingIn,
  linesOf,
  rangeOfPart,
  type SourceFile,
  sourceFiles,
  symbolNamed,
} from '../../../../web/src/views/code/sources.ts';
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

describe('one function of a file', () => {
  it('begins with what is said above it and ends with its brace', () => {
    const part = { file: 'right_parts.cpp', name: 'system_of' } as const;
    const { first, end } = rangeOfPart(part);
    const lines = linesOf(part.file).slice(first, end);
    expect(lines[0]).toMatch(/^\/\/\/ Q = /);
    expect(lines[1]).toMatch(/^Triplets system_of\(/);
    expect(lines.at(-1)).toBe('}');
  });

  it('that is not there is an error of the author', () => {
    expect(() => rangeOfPart({ file: 'local_step.cpp', name: 'step' })).toThrow('no function step');
  });

  it('differs from one that is written alike in the lines that make the difference', () => {
    const right = { file: 'signed_incidence_matrix.cpp', name: 'signed_incidence_matrix' } as const;
    const wrong = { file: 'solver_parts.cpp', name: 'incidence_without_minus' } as const;
    const line = (part: typeof right | typeof wrong, numbers: ReadonlySet<number>) =>
      [...numbers].map((at) => linesOf(part.file)[at].trim());
    expect(line(wrong, linesMissingIn(right, wrong))).toEqual(['A.emplace_back(e, E(e, 1), 1.0);']);
    expect(line(right, linesMissingIn(wrong, right))).toEqual(['A.emplace_back(e, E(e, 1), -1.0);']);
  });
});
