import type { MatchResult, Node } from 'ohm-js';
import { formulaGrammar } from './formula_grammar.ts';

const { raw } = String;

/** Names that TeX has no command for. */
const spelled: Readonly<Record<string, string>> = {
  asin: raw`\arcsin`,
  acos: raw`\arccos`,
  atan: raw`\arctan`,
  pi: raw`\pi`,
  π: raw`\pi`,
  e: raw`\mathrm{e}`,
  t: 't',
};

const tex = (node: Node): string => node.tex();
const inParentheses = (inside: string) => raw`\left(${inside}\right)`;

/** As the right side of a sign: a − (−b). */
function behindSign(node: Node): string {
  const inside = tex(node); // once: signs may be nested, and each would double the work
  return inside.startsWith('-') ? inParentheses(inside) : inside;
}

/** Where a bar or a raised line groups already: (a + b)/2 is one fraction without parentheses. */
function bare(node: Node): string {
  const inner = alone(node);
  return inner.ctorName === 'Atom_parentheses' ? tex(inner.child(1)) : tex(node);
}

/** Past the rules that only pass on. */
function alone(node: Node): Node {
  return node.numChildren === 1 && /^(Sum|Product|Signed|Power|Atom)/.test(node.ctorName) ? alone(node.child(0)) : node;
}

/** sin(t)² is written sin²(t): a power behind large parentheses would look like one of the argument. */
function raised(base: Node, exponent: string): string {
  const inner = alone(base);
  const f = inner.ctorName === 'Call' ? nameOf(inner) : '';
  if (f === '' || f === 'sqrt' || f === 'abs') return `{${tex(base)}}^{${exponent}}`;
  return `${functionCommand(f)}^{${exponent}}${inParentheses(argumentOf(inner))}`;
}

const nameOf = (call: Node) => call.child(0).sourceString.toLowerCase();
const argumentOf = (call: Node) => tex(call.child(2).asIteration().child(0));
const functionCommand = (f: string) => spelled[f] ?? `\\${f}`;

const semantics = formulaGrammar.createSemantics().addOperation<string>('tex', {
  Sum_plus: (a, _, b) => `${tex(a)}+${behindSign(b)}`,
  Sum_minus: (a, _, b) => `${tex(a)}-${behindSign(b)}`,
  Product_times: (a, _, b) => raw`${tex(a)}\cdot ${behindSign(b)}`,
  Product_over: (a, _, b) => raw`\frac{${bare(a)}}{${bare(b)}}`,
  Product_beside: (a, b) => raw`${tex(a)}\,${tex(b)}`,
  Signed_minus: (_, a) => `-${behindSign(a)}`,
  Signed_plus: (_, a) => tex(a),
  Power_to: (a, _, b) => raised(a, bare(b)),
  Power_superscript: (a, b) => raised(a, tex(b)),
  Atom_parentheses: (_, a, __) => inParentheses(tex(a)),
  Call(_, __, ___, ____) {
    const f = nameOf(this);
    if (f === 'sqrt') return raw`\sqrt{${argumentOf(this)}}`;
    if (f === 'abs') return raw`\left|${argumentOf(this)}\right|`;
    return functionCommand(f) + inParentheses(argumentOf(this));
  },
  name(_) {
    return spelled[this.sourceString.toLowerCase()] as string;
  },
  number(mantissa, exponent) {
    const power = exponent.sourceString.slice(1).replace(/[−–]/, '-').replace('+', '');
    return power ? raw`${mantissa.sourceString}\cdot 10^{${power}}` : mantissa.sourceString;
  },
  superscript(_, __) {
    return this.sourceString.normalize('NFKC').replace('−', '-');
  },
});

/** A formula that means something, as TeX: nothing in it is the reader's own text but numbers. */
export function formulaTeX(match: MatchResult): string {
  return tex(semantics(match) as unknown as Node);
}
