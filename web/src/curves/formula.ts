import { compileFormula, MeaninglessFormula } from './compile_formula.ts';
import { curveLimits } from './curve_choice.ts';
import { type CurveReason, columnAt } from './curve_problem.ts';
import { formulaGrammar, functions } from './formula_grammar.ts';
import { formulaTeX } from './formula_tex.ts';

const deepest = 30; // parentheses; the parser's own stack bears about a hundred

export interface Formula {
  at(t: number): number;
  /** As it is read: 1/2 t is a half in front of t. */
  tex(): string;
  /** Where t first stands, as a column from 1; null in a constant. */
  columnOfT: number | null;
}

export interface FormulaMistake {
  column: number;
  reason: CurveReason;
}

/** Reads an expression of t. Nothing of it is ever run as code. */
export function parseFormula(typed: string): Formula | FormulaMistake {
  const mistake = (index: number, reason: CurveReason) => ({ column: columnAt(typed, index), reason });
  if (typed.trim() === '') return mistake(0, { code: 'empty' });
  const maximum = curveLimits.formula;
  if (typed.length > maximum) return mistake(maximum, { code: 'too_long', maximum });
  const text = halfWidth(typed);
  const parentheses = parenthesesOf(text);
  if (parentheses.tooDeep !== null) return mistake(parentheses.tooDeep, { code: 'nested_too_deep', maximum: deepest });

  const match = formulaGrammar.match(text, 'Sum');
  if (match.failed()) {
    const index = match.getRightmostFailurePosition();
    if (index < text.length) {
      const [name = ''] = /\p{L}+(?=\s*$)/u.exec(text.slice(0, index)) ?? [];
      if (functions.has(name.toLowerCase()))
        return mistake(text.lastIndexOf(name, index), { code: 'function_without_parentheses', name });
      if (index === parentheses.unopened) return mistake(index, { code: 'not_opened' });
      return mistake(index, { code: 'unexpected', found: String.fromCodePoint(typed.codePointAt(index) as number) });
    }
    const lacksOperand = /[-−–+*×·⋅/÷^(,]\s*$/.test(text);
    if (parentheses.unclosed === null || lacksOperand) return mistake(text.trimEnd().length, { code: 'ends_early' });
    return mistake(parentheses.unclosed, { code: 'not_closed' });
  }
  try {
    const t = text.search(/(?<![^\P{L}π])[tT](?![^\P{L}π])/u); // π is a name of its own: in πt there is a t
    return { at: compileFormula(match), tex: () => formulaTeX(match), columnOfT: t < 0 ? null : columnAt(typed, t) };
  } catch (error) {
    if (error instanceof MeaninglessFormula) return mistake(error.index, error.reason);
    throw error;
  }
}

/** Full-width forms, as Chinese input methods give them, become what they mean; every index stays. */
function halfWidth(text: string): string {
  return text.replace(/[\uff01-\uff5e\u3000]/g, (character) => character.normalize('NFKC'));
}

/** Where parentheses are wrong: the last that stays open, the first that closes none, the first that lies too deep. */
function parenthesesOf(text: string) {
  const open: number[] = [];
  let unopened: number | null = null;
  let tooDeep: number | null = null;
  for (const { 0: character, index } of text.matchAll(/[()]/g)) {
    if (character === '(') open.push(index);
    else if (open.pop() === undefined) unopened ??= index;
    if (open.length > deepest) tooDeep ??= index;
  }
  return { unclosed: open.at(-1) ?? null, unopened, tooDeep };
}
