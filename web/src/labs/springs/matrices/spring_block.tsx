import { parameters, r } from '../../../app/state.ts';
import { entryFormat } from '../../../lib/entry_format.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatFixed, formatLength, formatNumber, formatQuantity } from '../../../lib/format.ts';
import { norm, row, subtract } from '../../../lib/vector.ts';
import type { LinearlyImplicitMatrices } from '../../../solver/matrices.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { Phrase } from '../../../views/equations/prose.tsx';
import { numbering } from './numbering.ts';
import { roomWords } from './room_words.ts';
import type { Stage } from './summands_of.ts';

const { raw } = String;

const definition = raw`\mathbf{H}_e = \symk\,\bigl[\mathbf{n}\mathbf{n}^{\mathrm T} + (1 - \symr_e/l)(\mathbf{I} - \mathbf{n}\mathbf{n}^{\mathrm T})\bigr]`;

/** Of the largest entry of a block: less is what is left of a 0, and twenty digits of it would say nothing. */
const rounding = 1e-12;

interface Props {
  read: LinearlyImplicitMatrices;
  stage: Stage;
  /** How many springs are added: it is about the last one. */
  count: number;
}

/** The last spring's block in numbers, where it goes, and whether it is indefinite. */
export function SpringBlock({ read, stage, count }: Props) {
  const words = roomWords().implicit;
  if (count === 0) return <p class="spring-block">{stage === 'K' ? words.none : words.noneWithMasses}</p>;
  const e = count - 1;
  const { E } = numbering.value;
  const [i, j] = [E[2 * e], E[2 * e + 1]];
  const block = read.stiffness.subarray(9 * e, 9 * e + 9);
  const { unit, write } = entryFormat(block, 'N/m');
  const largest = block.reduce((most, entry) => Math.max(most, Math.abs(entry)), 0);
  const x = subtract(row(read.q, i), row(read.q, j));
  const l = norm(x);
  return (
    <section class="spring-block">
      <h3>{fillTemplate(words.spring, { e, i, j })}</h3>
      <p class="wide-line">
        <Formula tex={definition} />
      </p>
      <p class="aside" data-testid="spring-lengths">
        {fillTemplate(words.lengths, {
          l: formatLength(l, 5),
          r: formatLength(r.value[e], 5),
          n: l === 0 ? '–' : `(${x.map((component) => formatFixed(component / l, 3)).join(', ')})`,
        })}
      </p>
      <table class="numbers">
        <caption class="visually-hidden">{fillTemplate(words.block, { e, unit: unit ?? '' })}</caption>
        <thead>
          <tr>
            <td>{unit}</td>
            {['x', 'y', 'z'].map((axis) => (
              <th key={axis} scope="col">
                {axis}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {['x', 'y', 'z'].map((axis, at) => (
            <tr key={axis}>
              <th scope="row">{axis}</th>
              {Array.from(block.subarray(3 * at, 3 * at + 3), (entry, column) => (
                <td key={column}>{write(Math.abs(entry) > rounding * largest ? entry : 0)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      <p role="status" data-testid="spring-places">
        <Places stage={stage} i={i} j={j} />
        {read.resistance && stage !== 'K' && (
          <>
            {' '}
            <Phrase text={words.damping} />
          </>
        )}
      </p>
      <p data-testid="spring-definite">
        <Definite l={l} rest={r.value[e]} />
      </p>
    </section>
  );
}

/** Where the four blocks go. */
function Places({ stage, i, j }: { stage: Stage; i: number; j: number }) {
  const words = roomWords().implicit.places;
  if (stage === 'constrained') {
    const fixed = [i, j].filter((vertex) => numbering.value.pinned.includes(vertex));
    if (fixed.length === 2) return <>{words.bothPinned}</>;
    const [pin] = fixed;
    if (pin !== undefined) return <>{fillTemplate(words.onePinned, { pin, free: pin === i ? j : i })}</>;
  }
  return <Phrase text={fillTemplate(stage === 'K' ? words.K : words.system, { i, j })} />;
}

/** Across the spring, which is where the block may be below zero. */
function Definite({ l, rest }: { l: number; rest: number }) {
  const words = roomWords().implicit;
  if (l === 0 && rest > 0) return <>{words.collapsed}</>;
  const across = rest === 0 ? 1 : 1 - rest / l;
  // Lengths are rounded in the 16th digit: closer to 0 nobody can tell stretched from compressed.
  const numbers = Math.abs(across) < 1e-12 ? 0 : across;
  const stiffness = formatQuantity(parameters.value.k * numbers, 'N/m');
  return (
    <Phrase
      text={fillTemplate(numbers < 0 ? words.compressed : words.stretched, {
        across: formatNumber(numbers),
        stiffness,
      })}
    />
  );
}
