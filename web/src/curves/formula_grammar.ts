import { grammar } from 'ohm-js';

/**
 * How students write formulas: products without a sign, powers that bind more tightly than a sign before them (−t² is −(t²)) and group from the
 * right. Products and quotients group from the left: 1/2 t is half of t. Two numbers side by side are no product: t2 is a slip, not 2 t.
 */
export const formulaGrammar = grammar(`
  Formula {
    Sum = Sum "+" Product -- plus
        | Sum minus Product -- minus
        | Product
    Product = Product times Signed -- times
            | Product over Signed -- over
            | Product ~number Power -- beside
            | Signed
    Signed = minus Signed -- minus
           | "+" Signed -- plus
           | Power
    Power = Atom "^" Signed -- to
          | Atom superscript -- superscript
          | Atom
    Atom = "(" Sum ")" -- parentheses
         | Call
         | name
         | number
    Call = ~(value ~letter) name "(" ListOf<Sum, ","> ")"

    name = "π" | (~"π" letter)+
    value = "π" | caseInsensitive<"pi"> | caseInsensitive<"t"> | caseInsensitive<"e">
    number = mantissa exponent?
    mantissa = digit+ ("." digit*)? -- whole
             | "." digit+ -- fraction
    exponent = caseInsensitive<"e"> ("+" | minus)? digit+
    superscript = "⁻"? superscriptDigit+
    superscriptDigit = "⁰" | "¹" | "²" | "³" | "⁴".."⁹"
    minus = "-" | "−" | "–"
    times = "*" | "×" | "·" | "⋅"
    over = "/" | "÷"
  }
`);

/** What a name stands for, besides t. */
export const constants: ReadonlyMap<string, number> = new Map([
  ['pi', Math.PI],
  ['π', Math.PI],
  ['e', Math.E],
]);

/** All take one argument; log is the natural one, as in programming languages. */
export const functions: ReadonlyMap<string, (x: number) => number> = new Map([
  ['sin', Math.sin],
  ['cos', Math.cos],
  ['tan', Math.tan],
  ['asin', Math.asin],
  ['acos', Math.acos],
  ['atan', Math.atan],
  ['sqrt', Math.sqrt],
  ['exp', Math.exp],
  ['log', Math.log],
  ['ln', Math.log],
  ['abs', Math.abs],
]);
