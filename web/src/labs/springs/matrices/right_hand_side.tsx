import { signal } from '@preact/signals';
import { useId } from 'preact/hooks';
import { t } from '../../../app/messages/index.ts';
import { frame, playing, scene } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { type ColumnScale, columnScale, formatInColumn } from '../../../lib/format.ts';
import { row } from '../../../lib/vector.ts';
import type { Frame, VertexEquation } from '../../../solver/frame.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { Prose } from '../../../views/equations/prose.tsx';
import { Stepper } from '../../../views/stepper/stepper.tsx';
import { roomWords } from './room_words.ts';

const { raw } = String;

/** How many springs have been added; null: all, of however many the vertex has. */
const added = signal<number | null>(null);

/** b of the selected vertex: y, and what every one of its springs adds. */
export function RightHandSide() {
  const words = roomWords().terms.b;
  const heading = useId();
  const now = frame.value as Frame;
  return (
    <section class="right-hand-side" aria-labelledby={heading}>
      <h3 id={heading}>{words.title}</h3>
      <Prose text={words.text} />
      {playing.value ? (
        <p class="aside">{words.playing}</p>
      ) : now.phase === 'predict' ? (
        <p class="aside">{t('equations.global.notYet')}</p>
      ) : now.vertexEquation ? (
        <Assembly equation={now.vertexEquation} />
      ) : (
        <p class="aside">{words.choose}</p>
      )}
    </section>
  );
}

function Assembly({ equation }: { equation: VertexEquation }) {
  const words = roomWords().terms.b;
  const { vertex, y, b, springs, shares } = equation;
  const { E } = scene.value;
  const step = Math.min(added.value ?? springs.length, springs.length);
  const scale = columnScale(Math.max(...[...shares, ...y, ...b].map(Math.abs)), 'N');
  const sum = runningSum(y, shares, step);
  return (
    <>
      <Stepper
        label={words.steps}
        step={step}
        last={springs.length}
        onStep={(next) => {
          added.value = next;
        }}
      />
      <table class="numbers assembly">
        <caption>{fillTemplate(words.caption, { vertex, unit: scale.unit })}</caption>
        <thead>
          <tr>
            <td />
            {['x', 'y', 'z'].map((axis) => (
              <th key={axis} scope="col">
                {axis}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr>
            <th scope="row">
              <Formula tex={raw`\symy_i`} />
            </th>
            <Cells vector={y} scale={scale} />
          </tr>
          {Array.from(springs, (e, at) => (
            <tr key={e} class={at < step ? '' : 'not-yet'} data-spring={e}>
              <th scope="row">
                <Formula tex={E[2 * e] === vertex ? raw`+\,\symk\,\symd_e` : raw`-\,\symk\,\symd_e`} />{' '}
                {fillTemplate(words.spring, { e })}
              </th>
              <Cells vector={row(shares, at)} scale={scale} />
            </tr>
          ))}
        </tbody>
        <tfoot>
          <tr>
            <th scope="row">{words.sum}</th>
            <Cells vector={sum} scale={scale} />
          </tr>
          <tr>
            <th scope="row">
              <Formula tex={raw`\symb_i`} /> {words.solver}
            </th>
            <Cells vector={b} scale={scale} />
          </tr>
        </tfoot>
      </table>
      <p class="aside assembly-end" role="status" data-complete={step === springs.length}>
        {step === springs.length && words.equal}
      </p>
    </>
  );
}

function Cells({ vector, scale }: { vector: readonly number[]; scale: ColumnScale }) {
  return (
    <>
      {vector.map((component, axis) => (
        <td key={axis}>{formatInColumn(component, scale)}</td>
      ))}
    </>
  );
}

/** N: y and the first `count` of the shares, #springs×3. */
function runningSum(y: readonly number[], shares: Float64Array, count: number): number[] {
  const sum = [...y];
  for (let at = 0; at < 3 * count; at++) sum[at % 3] += shares[at];
  return sum;
}
