import { describe, expect, it } from 'vitest';
import { librarySceneNames } from '../../../../../web/src/app/scene_library.ts';
import { cards } from '../../../../../web/src/labs/springs/misconceptions/cards.ts';
import { mistakes } from '../../../../../web/src/solver/mistaken_simulation.ts';
import { linesMissingIn } from '../../../../../web/src/views/code/sources.ts';
import { renderTeX } from '../../../../../web/src/views/equations/render_tex.ts';

it('there is a card for every mistake of the core', () => {
  expect(['none', ...cards.map(({ mistake }) => mistake)]).toEqual([...mistakes]);
});

describe.each(cards)('$mistake', ({ scene, also, wrong, right, code }) => {
  it('is shown in scenes of the library', () => {
    for (const name of [scene, ...also]) expect(librarySceneNames).toContain(name);
  });

  it('has two formulas that can be set, and functions of the core that differ in three lines at most, or in all', () => {
    expect(renderTeX(wrong, true)).not.toBe(renderTeX(right, true));
    for (const pair of code) {
      for (const marked of [linesMissingIn(pair.right, pair.wrong), linesMissingIn(pair.wrong, pair.right)])
        expect(marked.size).toBeLessThanOrEqual(3);
    }
  });
});
