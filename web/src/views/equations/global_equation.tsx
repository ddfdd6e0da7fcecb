import { t } from '../../app/messages/index.ts';
import { parameters } from '../../app/state.ts';
import { columnScale, formatLength, formatQuantity } from '../../lib/format.ts';
import { formulas } from '../../notation/formulas.ts';
import type { Frame, VertexEquation } from '../../solver/frame.ts';
import type { MinimisingParameters } from '../../solver/module.ts';
import { EquationPanel } from './equation_panel.tsx';
import { Formula } from './formula.tsx';
import { VectorTable } from './vector_table.tsx';
import { vertexMove } from './vertex_move.ts';

const { raw } = String;

const globalFormulas = [...formulas.global_step, ...formulas.right_hand_side, ...formulas.inertial_right_hand_side];

/** The global step's equation, its row for the selected vertex, and how well it is solved. */
export function GlobalEquation({ frame }: { frame: Frame }) {
  const event = frame.events[frame.half_step];
  return (
    <EquationPanel
      title={t('equations.global.title')}
      formulas={globalFormulas}
      known={['d', 'y', 'Q']}
      unknown="p"
      active={frame.phase === 'global'}
      note={noteAt(frame, parameters.value)}
    >
      {frame.vertexEquation ? (
        <VertexRow frame={frame} equation={frame.vertexEquation} />
      ) : (
        <p class="equation-note">{t('equations.global.invite')}</p>
      )}
      {event && !Number.isNaN(event.residual) && (
        <p class="equation-facts">
          <span>
            {t('equations.global.residual')} <Formula tex={raw`\lVert \symQ\symp - \symb \rVert_\infty`} /> ={' '}
            {formatQuantity(event.residual, 'N', 2)}
          </span>
        </p>
      )}
    </EquationPanel>
  );
}

function noteAt({ phase, vertexEquation, pinned }: Frame, { method, path }: MinimisingParameters): string | null {
  if (phase === 'predict') return t('equations.global.notYet');
  if (method !== 'local-global') return t(`equations.global.method.${method}`);
  if (path === 'fast' && vertexEquation && pinned.includes(vertexEquation.vertex)) return t('equations.global.pinned');
  return phase === 'local' ? t('equations.global.waiting') : null;
}

/** Row i of the equation with its numbers. At predict there is no d, hence no b, hence no numbers. */
function VertexRow({ frame, equation }: { frame: Frame; equation: VertexEquation }) {
  const { vertex, kAtd, y, b, Qp } = equation;
  const scale = columnScale(Math.max(...[...kAtd, ...y, ...b, ...Qp].map(Math.abs)), 'N');
  return (
    <>
      <p class="equation-facts">
        <strong>{t('equations.global.vertex', { index: vertex })}</strong>
        {frame.phase === 'global' && (
          <span>{t('equations.global.moved', { length: formatLength(vertexMove(frame, vertex)) })}</span>
        )}
      </p>
      {frame.phase !== 'predict' && (
        <VectorTable
          caption={t('equations.global.table', { index: vertex, unit: scale.unit })}
          scale={scale}
          rows={[
            { tex: raw`(\symk\symA^{\mathrm T}\symd)_i`, vector: kAtd },
            { tex: raw`+\;\symy_i`, vector: y },
            { tex: raw`=\;\symb_i`, vector: b },
            { tex: raw`(\symQ\symp)_i`, vector: Qp },
          ]}
        />
      )}
    </>
  );
}
