import katex from 'katex';
import { symbolMacros } from '../../notation/macros.ts';
import { isSymbolId } from '../../notation/symbols.ts';

/** TeX of the page's own making only: author's text, and formulas that readers type once they are parsed and written anew. */
const rendered = new Map<string, string>();
const most = 2000; // more than the source has; typed ones could be any number

/** HTML for the eye and MathML for the screen reader; every symbol of the table carries `data-sym`. */
export function renderTeX(tex: string, display: boolean): string {
  const key = `${display ? 'display' : 'inline'} ${tex}`;
  let html = rendered.get(key);
  if (html === undefined) {
    html = katex.renderToString(tex, {
      displayMode: display,
      output: 'htmlAndMathml',
      macros: { ...symbolMacros },
      strict: (code) => (code === 'htmlExtension' ? 'ignore' : 'error'),
      trust: isSymbolHook,
    });
    if (rendered.size >= most) rendered.clear();
    rendered.set(key, html);
  }
  return html;
}

function isSymbolHook(context: katex.TrustContext): boolean {
  if (context.command === '\\htmlClass') return context.class === 'sym';
  if (context.command !== '\\htmlData') return false;
  const attributes = Object.entries(context.attributes);
  return attributes.every(([name, value]) => name === 'data-sym' && isSymbolId(value));
}
