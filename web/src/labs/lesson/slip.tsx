import { Prose } from '../../views/equations/prose.tsx';
import { WideFormula } from '../../views/equations/wide_formula.tsx';
import type { FigureSession } from './figures/figure_session.ts';
import { type AtPoint, GradientCheck } from './gradient_check.tsx';
import { lessonWords } from './lesson_words.ts';
import './slip.css';

interface Props {
  figure: FigureSession;
  /** TeX. */
  printed: string;
  right: string;
  why: string;
  /** J: E as it is printed. */
  printedEnergy: (at: AtPoint) => number;
}

/** A formula as it is printed and as it is right, and a check that anybody can redo: whose differences are the gradient? */
export function Slip({ figure, printed, right, why, printedEnergy }: Props) {
  const words = lessonWords().slip;
  return (
    <aside class="slip" aria-label={words.label}>
      <p class="slip-label" aria-hidden="true">
        {words.label}
      </p>
      <div class="slip-columns">
        <div>
          <dl>
            <dt>
              <span class="slip-wrong">✗</span> {words.printed}
            </dt>
            <dd>
              <WideFormula tex={printed} />
            </dd>
            <dt>
              <span class="slip-right">✓</span> {words.right}
            </dt>
            <dd>
              <WideFormula tex={right} />
            </dd>
          </dl>
          <Prose text={why} />
        </div>
        <GradientCheck figure={figure} printedEnergy={printedEnergy} />
      </div>
    </aside>
  );
}
