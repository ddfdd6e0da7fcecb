import { expect, it } from 'vitest';
import { choiceOf, countOf, entries, entryOf, nextChoice } from '../../../../web/src/labs/integrators/entries.ts';
import { namesOf } from '../../../../web/src/labs/integrators/names.ts';

it('every entry can be chosen, and is recognised again', () => {
  for (const entry of entries) expect(entryOf(choiceOf(entry))).toBe(entry);
});

it('what iterates offers iterations, what does not, substeps; Newton’s method decides by itself', () => {
  expect(entries.map(countOf)).toEqual([
    ...['substeps', 'substeps', 'substeps', null, null],
    ...['iterations', 'iterations', 'iterations', 'iterations'],
  ]);
});

it('an added method is one that is not there yet', () => {
  const three = [nextChoice([])];
  for (let more = 0; more < 2; more++) three.push(nextChoice(three));
  expect(new Set(three.map(entryOf)).size).toBe(3);
});

it('names say the counts that matter, and differ', () => {
  const local = choiceOf('local-global');
  expect(namesOf([local, { ...local, iterations: 50 }, local, { ...choiceOf('forward-euler'), substeps: 4 }])).toEqual([
    'Local/global × 10',
    'Local/global × 50',
    'Local/global × 10 (2)',
    'Forward Euler, 4 substeps',
  ]);
});
