import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { formatQuantity } from '../../../../lib/format.ts';
import { symbolCommand } from '../../../../notation/macros.ts';
import type { Evaluation } from '../../../../solver/protocol.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession } from '../../figures/figure_session.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { en } from './en.ts';
import { Landscape } from './landscape.tsx';
import { free, landscapePoints } from './landscape_grid.ts';
import { type Term, termSymbols, terms, termValue } from './terms.ts';
import { zh } from './zh.ts';

/** E as a map of the plane, whole or term by term. */
export function LandscapeFigure({ figure }: { figure: FigureSession }) {
  const words = inLanguage({ en, zh }).landscape;
  const [term, setTerm] = useState<Term>('sum');
  const seen = useInspection(figure, landscapePoints);
  const here = seen?.evaluations[0];
  return (
    <Figure
      figure={figure}
      pictures={['net']}
      behind={({ plane }) => seen && <Landscape seen={seen} plane={plane} term={term} />}
      sliders={['delta_t', 'k', 'mass_scale']}
      caption={words.caption}
    >
      <fieldset class="landscape-terms">
        <legend>{words.shown}</legend>
        {terms.map((one) => (
          <label key={one}>
            <input type="radio" name="term" checked={one === term} onChange={() => setTerm(one)} /> {words.terms[one]}
          </label>
        ))}
      </fieldset>
      <dl class="landscape-values" aria-label={words.values}>
        {[...terms.slice(1), terms[0]].map((one) => (
          <Value key={one} tex={symbolCommand(termSymbols[one])} value={here && termValue(one, here)} unit="J" />
        ))}
        <Value tex={slope} value={here && slopeOf(here)} unit="N" />
      </dl>
    </Figure>
  );
}

const { raw } = String;
const slope = raw`\lVert\symgradient\rVert`;

/** N: how steep E is for the free vertex. */
function slopeOf({ gradient }: Evaluation): number {
  return Math.hypot(...gradient.subarray(3 * free, 3 * free + 3));
}

function Value({ tex, value, unit }: { tex: string; value: number | undefined; unit: string }) {
  return (
    <div>
      <dt>
        <Formula tex={tex} />
      </dt>
      <dd>{value !== undefined && formatQuantity(value, unit)}</dd>
    </div>
  );
}
