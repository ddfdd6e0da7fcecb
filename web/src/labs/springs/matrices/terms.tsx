import { signal, useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { highlighted } from '../../../app/highlight.ts';
import { labFigure, parameters } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatQuantity } from '../../../lib/format.ts';
import type { Matrices } from '../../../solver/matrices.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { Prose } from '../../../views/equations/prose.tsx';
import { SparsityView } from '../../../views/sparsity/sparsity_view.tsx';
import { numbered } from './axes.ts';
import { modelOf } from './model_of.ts';
import { numbering } from './numbering.ts';
import { RightHandSide } from './right_hand_side.tsx';
import { roomWords } from './room_words.ts';
import { selectThings } from './select_things.ts';
import { sumOfTerms, type Term, termAt, termPatterns, terms } from './sum_of_terms.ts';

const { raw } = String;

const formulas: Record<Term, string> = {
  springs: raw`\symk\symA^{\mathrm T}\symA`,
  masses: raw`\symM/\symdeltaT^2`,
  pins: raw`\symw\symC^{\mathrm T}\symC`,
};

/** For every set of terms, by its bits; the rarest first, which is seen from afar. No entry comes from no term. */
const colours = Array.from({ length: 8 }, (_, bits) =>
  bits === 0
    ? ['--muted']
    : terms
        .filter((_, bit) => bits & (1 << bit))
        .map((term) => `--term-${term}`)
        .reverse(),
);

const chosen = signal<readonly Term[]>(terms);

/** Q built up by its three terms, and b by the springs of one vertex. */
export function Terms({ matrices, actions }: { matrices: Matrices; actions: Actions }) {
  const words = roomWords().terms;
  const on = chosen.value;
  const { E, vertexCount } = numbering.value;
  const patterns = useMemo(() => termPatterns(matrices), [matrices]);
  const model = useMemo(() => {
    const { sum, from } = sumOfTerms(matrices.Q, patterns, on);
    const vertices = numbered('vertex', vertexCount);
    return modelOf({
      symbol: 'Q',
      triplets: sum,
      rows: vertices,
      columns: vertices,
      E,
      kinds: { of: (triplet) => from[triplet], colours },
      remark: (entry, _, place) => {
        if (entry < 0) return '';
        const parts = terms.flatMap((term) => {
          const part = on.includes(term) ? termAt(patterns, term, place) : 0;
          return part === 0 ? [] : [`${roomWords().terms[term]} ${formatQuantity(part, 'N/m')}`];
        });
        return fillTemplate(roomWords().terms.parts, { parts: parts.join(' + ') });
      },
    });
  }, [matrices, patterns, on, E, vertexCount]);

  return (
    <div class="terms">
      <div class="terms-q">
        <Prose text={words.text} />
        <fieldset class="term-toggles" aria-label={words.label}>
          <Formula tex={raw`\symQ =`} />
          {terms.map((term, at) => (
            <TermToggle
              key={term}
              term={term}
              first={at === 0}
              empty={patterns[term].value.length === 0}
              pressed={on.includes(term)}
              isIn={(row, column) => termAt(patterns, term, { row, column }) !== 0}
              onToggle={() => {
                chosen.value = terms.filter((other) => on.includes(other) !== (other === term));
              }}
            />
          ))}
        </fieldset>
        <SparsityView figure={labFigure} model={model} label={words.label} onSelect={selectThings(actions)} />
        {parameters.value.path === 'fast' && patterns.pins.value.length > 0 && <p class="aside">{words.exact}</p>}
      </div>
      <RightHandSide />
    </div>
  );
}

interface ToggleProps {
  term: Term;
  first: boolean;
  empty: boolean;
  pressed: boolean;
  isIn: (row: number, column: number) => boolean;
  onToggle: () => void;
}

/** A term of the formula, to be switched on and off. It lights up where the entry pointed at has something of it. */
function TermToggle({ term, first, empty, pressed, isIn, onToggle }: ToggleProps) {
  const words = roomWords().terms;
  const { E } = numbering.value;
  const lit = useComputed(() => {
    const { symbols, spring, vertex } = highlighted.value;
    if (!symbols.includes('Q')) return false;
    return spring === null ? vertex !== null && isIn(vertex, vertex) : isIn(E[2 * spring], E[2 * spring + 1]);
  });
  return (
    <>
      {!first && '+'}
      <button
        type="button"
        class={`term-toggle ${pressed && lit.value ? 'lit' : ''}`}
        style={{ '--term': `var(--term-${term})` }}
        aria-pressed={pressed}
        disabled={empty}
        onClick={onToggle}
      >
        <Formula tex={formulas[term]} />
        <span>{empty ? words.none : words[term]}</span>
      </button>
    </>
  );
}
