import { useState } from 'preact/hooks';
import { Formula } from '../../../../views/equations/formula.tsx';
import { MatrixTable } from '../../../../views/matrices/matrix_table.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { sumOf, type Term, terms } from './terms_of_q.ts';

const { raw } = String;

/** With a small w, so that the numbers of all three terms can be read side by side. */
const penalised: FigureSettings = { scene: 'triangle', parameters: { w: 1e4 }, selection: { spring: 1, vertex: 2 } };

const formulas: Record<Term, string> = {
  springs: raw`\symk\symA^{\mathrm T}\symA`,
  masses: raw`\symM/\symdeltaT^2`,
  pins: raw`\symw\symC^{\mathrm T}\symC`,
};

type Words = Record<'caption' | 'terms' | Term, string>;

/** Q of a triangle, built up by its three terms. */
export function QTerms({ words }: { words: Words }) {
  const figure = useFigure(penalised);
  const seen = useInspection(figure);
  const [on, setOn] = useState<readonly Term[]>(terms);
  const toggle = (term: Term) => setOn(on.includes(term) ? on.filter((other) => other !== term) : [...on, term]);
  const { k, delta_t, w } = figure.parameters.value;
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k', 'mass_scale', 'delta_t', 'w']} caption={words.caption}>
      <fieldset class="q-terms">
        <legend>{words.terms}</legend>
        {terms.map((term) => (
          <label key={term}>
            <input type="checkbox" checked={on.includes(term)} onChange={() => toggle(term)} />
            <Formula tex={formulas[term]} /> {words[term]}
          </label>
        ))}
      </fieldset>
      <div class="matrices-room">
        {seen && (
          <MatrixTable
            figure={figure}
            symbol="Q"
            values={sumOf(on, seen, { k, delta_t, w })}
            name={<Formula tex={raw`\symQ`} />}
          />
        )}
      </div>
    </Figure>
  );
}
