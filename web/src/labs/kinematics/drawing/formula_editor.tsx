import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import type { CurveField as FieldName } from '../../../curves/curve_problem.ts';
import { parseFormula } from '../../../curves/formula.ts';
import { WideFormula } from '../../../views/equations/wide_formula.tsx';
import { CurveField } from './curve_field.tsx';
import { CurvePicture } from './curve_picture.tsx';
import { en } from './en.ts';
import { type FormulaChoice, type FormulaName, formulas } from './examples.ts';
import { ProblemNote } from './problem_note.tsx';
import { useDraft } from './use_draft.ts';
import { zh } from './zh.ts';

export function FormulaEditor({ drawn, actions }: { drawn: FormulaChoice; actions: Actions }) {
  const words = inLanguage({ en, zh }).formula;
  const { typed, problem, type } = useDraft(drawn, actions);
  const field = (id: Extract<FieldName, 'x' | 'y' | 'from' | 'to'>) => (
    <CurveField
      id={id}
      label={words[id]}
      value={typed[id]}
      problem={problem}
      hint="curve-hint"
      onType={(text) => type({ ...typed, [id]: text })}
    />
  );
  return (
    <>
      <div class="curve-formula">
        {field('x')}
        {field('y')}
        {field('from')}
        {field('to')}
      </div>
      <ProblemNote id="curve-problem" text={problem ? typed[problem.field as 'x'] : ''} problem={problem} />
      <WideFormula tex={texOf(drawn)} />
      <p id="curve-hint" class="curve-hint">
        {words.hint}
      </p>
      <fieldset class="curve-examples">
        <legend>{words.examples}</legend>
        {(Object.keys(formulas) as FormulaName[]).map((name) => (
          <button key={name} type="button" onClick={() => type(formulas[name])}>
            <CurvePicture choice={formulas[name]} />
            {words.names[name]}
          </button>
        ))}
      </fieldset>
    </>
  );
}

/** What the arm draws: x over y. */
function texOf({ x, y, from, to }: FormulaChoice): string {
  const [texX, texY, texFrom, texTo] = [x, y, from, to].map((text) => {
    const formula = parseFormula(text);
    return 'reason' in formula ? '' : formula.tex();
  });
  return String.raw`\begin{aligned}x(t)&=${texX}\\y(t)&=${texY}\end{aligned}\qquad ${texFrom}\le t\le ${texTo}`;
}
