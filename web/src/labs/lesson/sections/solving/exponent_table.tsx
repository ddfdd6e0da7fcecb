import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import type { PowerLaw } from '../../../../lib/fit_power_law.ts';
import { formatFixed } from '../../../../lib/format.ts';
import { type SolvingCall, solvingCalls } from '../../../../solver/time_solving.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** What counting operations predicts for a net of n vertices. */
const expected: Record<SolvingCall, string> = {
  dense_inverse: 'n^3',
  dense_factorise: 'n^3',
  dense_substitute: 'n^2',
  sparse_factorise: 'n^{1.5}',
  sparse_substitute: String.raw`n \log n`,
};

/** How the time of each call grows with n, by theory and here. */
export function ExponentTable({ laws }: { laws: Partial<Record<SolvingCall, PowerLaw>> }) {
  const words = inLanguage({ en, zh }).timing;
  return (
    <table class="numbers">
      <caption>{words.exponents}</caption>
      <thead>
        <tr>
          <th scope="col">{words.call}</th>
          <th scope="col">{words.theory}</th>
          <th scope="col">{words.measured}</th>
        </tr>
      </thead>
      <tbody>
        {solvingCalls.map((call) => {
          const law = laws[call];
          return (
            <tr key={call} data-call={call}>
              <th scope="row">{words.calls[call]}</th>
              <td>
                <Formula tex={expected[call]} />
              </td>
              <td>{law ? <Measured {...law} /> : '–'}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function Measured({ exponent, points }: PowerLaw) {
  const words = inLanguage({ en, zh }).timing;
  return (
    <>
      <Formula tex={`n^{${formatFixed(exponent, 2)}}`} />{' '}
      <span class="aside">{fillTemplate(words.points, { points: points.length })}</span>
    </>
  );
}
