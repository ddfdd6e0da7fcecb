import { t } from '../../app/messages/index.ts';
import { parameters } from '../../app/state.ts';
import { columnScale, formatLength, formatQuantity } from '../../lib/format.ts';
import type { Frame, VertexEquation } from '../../solver/frame.ts';
import { EquationPanel } from './equation_panel.tsx';
import { VectorTable } from './vector_table.tsx';
import { vertexMove } from './vertex_move.ts';

const { raw } = String;

export const globalFormulas = [
  raw`\symQ\symp = \symb`,
  raw`\symb = \symk\symA^{\mathsf T}\symd + \symy`,
  raw`\symy = \frac{\symM\,(2\sympCurr - \sympPrev)}{\symdeltaT^2} + \symfExt + \symw\symC^{\mathsf T}\symC\,\sympTarget`,
] as const;

/** The global step's equation, its row for the selected vertex, and how well it is solved. */
export function GlobalEquation({ frame }: { frame: Frame }) {
  const { k, delta_t, w } = parameters.value;
  return (
    <EquationPanel
      title={t('equations.global.title')}
      formulas={globalFormulas}
      symbols={['Q', 'p', 'b', 'k', 'A', 'd', 'y', 'M', 'deltaT', 'pCurr', 'pPrev', 'fExt', 'w', 'C', 'pTarget']}
      known={['d', 'y', 'Q']}
      unknown="p"
      active={frame.phase === 'global'}
      values={{ k: formatQuantity(k, 'N/m'), deltaT: formatQuantity(delta_t, 's'), w: formatQuantity(w, 'N/m') }}
    >
      {frame.vertexEquation ? (
        <VertexRow frame={frame} equation={frame.vertexEquation} />
      ) : (
        <p class="equation-invitation">{t('equations.global.invite')}</p>
      )}
      <Residual frame={frame} />
    </EquationPanel>
  );
}

function VertexRow({ frame, equation }: { frame: Frame; equation: VertexEquation }) {
  const { vertex, kAtd, y, b, Qp } = equation;
  const hasProjection = frame.phase !== 'predict';
  const scale = columnScale(Math.max(...[...kAtd, ...y, ...b, ...Qp].map(Math.abs)), 'N', 5);
  return (
    <>
      <p class="equation-facts">
        <strong>{t('equations.global.vertex', { index: vertex })}</strong>
        {frame.phase === 'global' && (
          <span>{t('equations.global.moved', { length: formatLength(vertexMove(frame, vertex)) })}</span>
        )}
        {frame.phase === 'local' && <span class="equation-aside">{t('equations.global.waiting')}</span>}
      </p>
      {hasProjection ? (
        <VectorTable
          caption={t('equations.global.table', { index: vertex, unit: scale.unit })}
          scale={scale}
          rows={[
            { tex: raw`(\symk\symA^{\mathsf T}\symd)_i`, vector: kAtd },
            { tex: raw`+\;\symy_i`, vector: y },
            { tex: raw`=\;\symb_i`, vector: b },
            { tex: raw`(\symQ\symp)_i`, vector: Qp },
          ]}
        />
      ) : (
        <p class="equation-aside">{t('equations.global.notYet')}</p>
      )}
    </>
  );
}

/** Only a global step solves, so only there a residual says anything. */
function Residual({ frame }: { frame: Frame }) {
  const event = frame.events.find(({ half_step }) => half_step === frame.half_step);
  if (event?.phase !== 'global') return null;
  return (
    <p class="equation-facts">
      <span>{t('equations.global.residual', { value: formatQuantity(event.residual, 'N', 2) })}</span>
      <span>{t('equations.global.change', { length: formatLength(event.change) })}</span>
    </p>
  );
}
