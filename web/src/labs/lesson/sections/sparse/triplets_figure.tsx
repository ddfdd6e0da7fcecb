import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatNumber } from '../../../../lib/format.ts';
import { Stepper } from '../../../../views/stepper/stepper.tsx';
import type { FigureSession } from '../../figures/figure_session.ts';
import { assembled, type Repetition, type Triplet } from './assembly.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

interface Props {
  figure: FigureSession;
  triplets: readonly Triplet[];
  /** How many of them are in the matrix. */
  inserted: number;
  onInsert: (count: number) => void;
  repetition: Repetition;
  onRepetition: (repetition: Repetition) => void;
}

/** Q filled by one triplet after the other. */
export function TripletsFigure({ figure, triplets, inserted, onInsert, repetition, onRepetition }: Props) {
  const words = inLanguage({ en, zh }).triplets;
  const n = figure.scene.value.m.length;
  const matrix = assembled(n, triplets.slice(0, inserted), repetition);
  const last = triplets[inserted - 1];
  const stored = matrix.flat().filter((value) => value !== null).length;
  return (
    <div class="triplets">
      <fieldset class="choices">
        <legend>{words.repetition}</legend>
        {(['add', 'overwrite'] as const).map((choice) => (
          <label key={choice}>
            <input
              type="radio"
              name="repetition"
              checked={choice === repetition}
              onChange={() => onRepetition(choice)}
            />
            {words[choice]}
          </label>
        ))}
      </fieldset>
      <Stepper label={words.steps} step={inserted} last={triplets.length} onStep={onInsert} />
      <p class="triplet" aria-live="polite" {...thingOf(last)}>
        {last ? fillTemplate(words[last.from.kind], valuesOf(last)) : words.none}
      </p>
      <table class="numbers matrix-numbers">
        <caption>{fillTemplate(words.matrix, { stored, all: n * n })}</caption>
        <thead>
          <tr>
            <td />
            {matrix.map((_, j) => (
              <th key={j} scope="col" data-vertex={j}>
                {j}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {matrix.map((row, i) => (
            <tr key={i}>
              <th scope="row" data-vertex={i}>
                {i}
              </th>
              {row.map((value, j) => (
                <td
                  key={j}
                  class={last && last.i === i && last.j === j ? 'inserted' : undefined}
                  data-about="Q"
                  data-row={i}
                  data-column={j}
                  data-value={value ?? 0}
                >
                  {value === null ? <span class="absent">·</span> : formatNumber(value)}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function valuesOf({ i, j, value, from }: Triplet) {
  return { i, j, value: formatNumber(value), index: from.index };
}

/** What asks for the triplet, for pointing at it. */
function thingOf(triplet: Triplet | undefined) {
  if (!triplet) return {};
  const { kind, index } = triplet.from;
  return kind === 'spring' ? { 'data-spring': index } : { 'data-vertex': index };
}
