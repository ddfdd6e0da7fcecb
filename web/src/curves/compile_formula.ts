import type { MatchResult, Node } from 'ohm-js';
import type { CurveReason } from './curve_problem.ts';
import { constants, formulaGrammar, functions } from './formula_grammar.ts';

/** A formula that is written as formulas are, but means nothing. Caught in parseFormula. */
export class MeaninglessFormula extends Error {
  readonly index: number;
  readonly reason: CurveReason;

  constructor(node: Node, reason: CurveReason) {
    super(reason.code);
    this.index = node.source.startIdx;
    this.reason = reason;
  }
}

type Compiled = (t: number) => number;

const unary = (f: (x: number) => number, node: Node): Compiled => {
  const x: Compiled = node.compiled();
  return (t) => f(x(t));
};

const binary = (f: (x: number, y: number) => number, left: Node, right: Node): Compiled => {
  const x: Compiled = left.compiled();
  const y: Compiled = right.compiled();
  return (t) => f(x(t), y(t));
};

const product = (x: number, y: number) => x * y;
const power = (x: number, y: number) => x ** y;
const superscripts = '⁰¹²³⁴⁵⁶⁷⁸⁹';

const semantics = formulaGrammar.createSemantics().addOperation<Compiled>('compiled', {
  Sum_plus: (a, _, b) => binary((x, y) => x + y, a, b),
  Sum_minus: (a, _, b) => binary((x, y) => x - y, a, b),
  Product_times: (a, _, b) => binary(product, a, b),
  Product_over: (a, _, b) => binary((x, y) => x / y, a, b),
  Product_beside: (a, b) => binary(product, a, b),
  Signed_minus: (_, a) => unary((x) => -x, a),
  Signed_plus: (_, a) => a.compiled(),
  Power_to: (a, _, b) => binary(power, a, b),
  Power_superscript: (a, b) => binary(power, a, b),
  Atom_parentheses: (_, a, __) => a.compiled(),
  Call: callOf,
  name: meaningOfName,
  number(_, __) {
    const value = Number(this.sourceString.replace(/[−–]/, '-'));
    return () => value;
  },
  superscript(sign, digits) {
    const size = Number([...digits.sourceString].map((digit) => superscripts.indexOf(digit)).join(''));
    const value = sign.numChildren > 0 ? -size : size;
    return () => value;
  },
});

function callOf(name: Node, _: Node, list: Node, __: Node): Compiled {
  const f = functions.get(keyOf(name));
  if (!f) throw new MeaninglessFormula(name, { code: 'unknown_name', name: name.sourceString });
  const listed = list.asIteration().children;
  if (listed.length !== 1)
    throw new MeaninglessFormula(name, {
      code: 'wrong_number_of_arguments',
      name: name.sourceString,
      count: listed.length,
    });
  return unary(f, listed[0] as Node);
}

function meaningOfName(this: Node, _: Node): Compiled {
  const key = keyOf(this);
  if (key === 't') return (t) => t;
  const value = constants.get(key);
  if (value !== undefined) return () => value;
  const code = functions.has(key) ? 'function_without_parentheses' : 'unknown_name';
  throw new MeaninglessFormula(this, { code, name: this.sourceString });
}

/** Keyboards of phones begin with a capital. */
function keyOf(name: Node): string {
  return name.sourceString.toLowerCase();
}

export function compileFormula(match: MatchResult): Compiled {
  return semantics(match).compiled();
}
