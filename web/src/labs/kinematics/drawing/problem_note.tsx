import { inLanguage } from '../../../app/messages/in_language.ts';
import type { CurveProblem } from '../../../curves/curve_problem.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

interface Props {
  id: string;
  /** What was typed. */
  text: string;
  /** Null: nothing, at present. */
  problem: CurveProblem | null;
}

/** What is wrong with a text, and a caret under where; screen readers hear it when the reader pauses. */
export function ProblemNote({ id, text, problem }: Props) {
  const words = inLanguage({ en, zh });
  const sentence = problem && words.problems[problem.code];
  return (
    <div id={id} class="curve-problem" role="status">
      {problem && sentence && (
        <>
          {sentence.includes('{{column}}') && <Excerpt text={text} column={problem.column} />}
          <p>
            {fillTemplate(sentence, shown(problem))} <span class="curve-kept">{words.kept}</span>
          </p>
        </>
      )}
    </div>
  );
}

const shownBefore = 24;
const shownBehind = 12;

/** A line of the text with its mistake marked; the caret is drawn by the style sheet, whatever the widths of the characters. */
function Excerpt({ text, column }: { text: string; column: number }) {
  const characters = [...text.replace(/\s/g, ' ')];
  const at = column - 1;
  const from = Math.max(0, at - shownBefore);
  const to = at + 1 + shownBehind;
  return (
    <code class="curve-excerpt" aria-hidden="true">
      {from > 0 && '…'}
      {characters.slice(from, at).join('')}
      <mark>{characters[at] ?? ' '}</mark>
      {characters.slice(at + 1, to).join('')}
      {to < characters.length && '…'}
    </code>
  );
}

/** The problem's values, numbers as readers know them. */
function shown(problem: CurveProblem): Record<string, string | number> {
  return Object.fromEntries(
    Object.entries(problem).map(([name, value]) => [
      name,
      typeof value === 'number' && !Number.isInteger(value) ? formatNumber(value, 4) : value,
    ]),
  );
}
