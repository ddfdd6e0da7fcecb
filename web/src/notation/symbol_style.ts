import { symbolIds, symbols } from './symbols.ts';
import './colours.css';

/**
 * The style of every element with `data-sym`: its symbol's colour, and a mark while `data-lit` on an element around it names the symbol. So all
 * occurrences light up at once, however many formulas the page holds, and no script visits them.
 */
export function symbolStyle(): string {
  const colours = symbolIds.map((id) => `[data-sym="${id}"] { color: var(${symbols[id].colour}); }`);
  const lit = symbolIds.map((id) => `[data-lit~="${id}"] [data-sym="${id}"]`);
  const mark =
    'background: color-mix(in srgb, currentColor var(--symbol-mark), transparent); box-shadow: 0 2px 0 currentColor';
  return [...colours, `:where(${lit.join(', ')}) { border-radius: 2px; ${mark}; }`].join('\n');
}
