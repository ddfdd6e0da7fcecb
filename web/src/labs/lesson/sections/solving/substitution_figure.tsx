import { useEffect, useMemo, useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatNumber } from '../../../../lib/format.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { Stepper } from '../../../../views/stepper/stepper.tsx';
import type { FigureSession } from '../../figures/figure_session.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { cholesky } from './cholesky.ts';
import { en } from './en.ts';
import { type SmallMatrix, smallMatrix } from './small_matrix.ts';
import { rowFormula, substitutionAt } from './substitution.ts';
import { zh } from './zh.ts';

const { raw } = String;

/** The heights: gravity acts on them. */
const column = 1;

/** Q p = b of the figure's present moment, solved row by row by hand: down through L, up through Lᵀ. */
export function SubstitutionFigure({ figure }: { figure: FigureSession }) {
  const words = inLanguage({ en, zh }).substitution;
  const [step, setStep] = useState(0);
  const seen = useInspection(figure);
  const numbersOfQ = seen?.Q.value.join();
  const numbersOfB = seen?.equations.map((equation) => equation.b).join();
  const counts = useCounts(numbersOfQ, numbersOfB);
  const factor = useMemo(() => seen && cholesky(smallMatrix(seen.Q)), [numbersOfQ]);
  if (!seen || !factor || !('L' in factor)) return <div class="substitution" />;

  const { L } = factor;
  const b = seen.equations.map((equation) => equation.b[column]);
  const { x, p, solved } = substitutionAt(L, b, step);
  const rowIn = (pass: 'forwards' | 'backwards') => (solved?.pass === pass ? solved.row : null);
  return (
    <div class="substitution">
      <Stepper label={words.steps} step={step} last={2 * L.length} onStep={setStep} />
      <div class="substitution-row">
        {solved ? <Formula tex={rowFormula(L.length, solved)} display /> : <p>{words.start}</p>}
      </div>
      <div class="substitution-tables">
        <Triangle
          caption={words.forwards}
          matrix={L}
          names={[raw`\symL`, 'x', raw`\symb`]}
          unknown={x}
          right={b}
          row={rowIn('forwards')}
        />
        <Triangle
          caption={words.backwards}
          matrix={L.map((_, i) => L.map((row) => row[i]))}
          names={[raw`\symL^{\mathrm T}`, raw`\symp`, 'x']}
          unknown={p}
          right={x}
          row={rowIn('backwards')}
        />
      </div>
      <p>{fillTemplate(words.counted, counts)}</p>
      <p role="status">
        {step === 2 * L.length &&
          fillTemplate(words.residual, { residual: formatNumber(residual(smallMatrix(seen.Q), p, b), 2) })}
      </p>
    </div>
  );
}

/** How often a new L was needed, and how often a new p, for a system that is known by all its numbers. */
function useCounts(Q: string | undefined, b: string | undefined) {
  const [factorised, setFactorised] = useState(0);
  const [solved, setSolved] = useState(0);
  useEffect(() => {
    if (Q) setFactorised((count) => count + 1);
  }, [Q]);
  useEffect(() => {
    if (Q) setSolved((count) => count + 1);
  }, [Q, b]);
  return { factorised, solved };
}

/** max |Q p − b|, N, once p is known. */
function residual(Q: SmallMatrix, p: readonly (number | null)[], b: readonly number[]): number {
  return Math.max(...Q.map((row, i) => Math.abs(row.reduce((sum, value, j) => sum + value * Number(p[j]), -b[i]))));
}

interface TriangleProps {
  caption: string;
  matrix: SmallMatrix;
  /** TeX: of the matrix, the unknown and the right-hand side. */
  names: readonly [string, string, string];
  unknown: readonly (number | null)[];
  right: readonly (number | null)[];
  /** The row just solved. */
  row: number | null;
}

/** A triangular system, a row of it marked. */
function Triangle({ caption, matrix, names, unknown, right, row: solved }: TriangleProps) {
  return (
    <table class="numbers triangle">
      <caption>{caption}</caption>
      <thead>
        <tr>
          <td />
          <Name tex={names[0]} span={matrix.length} />
          <Name tex={names[1]} span={1} />
          <Name tex={names[2]} span={1} />
        </tr>
      </thead>
      <tbody>
        {matrix.map((row, i) => (
          <tr key={i} class={i === solved ? 'solved' : undefined} data-vertex={i}>
            <th scope="row">{i}</th>
            {row.map((value, j) => (
              <td key={j} class={value === 0 ? 'zero' : undefined}>
                {formatNumber(value)}
              </td>
            ))}
            <td class="unknown">{shown(unknown[i])}</td>
            <td class="right">{shown(right[i])}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Name({ tex, span }: { tex: string; span: number }) {
  return (
    <th scope={span > 1 ? 'colgroup' : 'col'} colSpan={span}>
      <Formula tex={tex} />
    </th>
  );
}

function shown(value: number | null): string {
  return value === null ? '?' : formatNumber(value);
}
