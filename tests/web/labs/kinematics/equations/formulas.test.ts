import { expect, it } from 'vitest';
import { forwardOf, kinematicsFormulas } from '../../../../../web/src/labs/kinematics/equations/formulas.ts';
import { renderTeX } from '../../../../../web/src/views/equations/render_tex.ts';
import { symbolsIn } from '../../../../../web/src/views/equations/symbols_in.ts';

const all = [...Object.values(kinematicsFormulas).flat(), forwardOf(0), forwardOf(20)];

it.each(all)('%s is set, and linked by the symbols it is made of', (tex) => {
  const html = renderTeX(tex, true);
  const ids = symbolsIn([tex]);
  expect(ids.length).toBeGreaterThan(0);
  for (const id of ids) expect(html).toContain(`data-sym="${id}"`);
  expect(html).not.toContain('katex-error');
});
