import { t } from '../../app/messages/index.ts';
import { columnScale, formatInColumn } from '../../lib/format.ts';
import { formulas } from '../../notation/formulas.ts';
import type { Frame } from '../../solver/frame.ts';
import { EquationPanel } from './equation_panel.tsx';
import { type Spring, type SpringNumbers, springNumbers } from './spring_numbers.ts';
import { strainText } from './strain_text.ts';
import { type VectorRow, VectorTable } from './vector_table.tsx';

const { raw } = String;

interface Props {
  frame: Frame;
  /** The selected spring. */
  spring: Spring | null;
}

/** The local step's equation, and what it does to the selected spring. */
export function LocalEquation({ frame, spring }: Props) {
  return (
    <EquationPanel
      title={t('equations.local.title')}
      formulas={formulas.local_step}
      known={['p', 'r']}
      unknown="d"
      active={frame.phase === 'local'}
      note={noteAt(frame)}
    >
      {spring ? (
        <Substitution spring={spring} numbers={springNumbers(frame, spring)} />
      ) : (
        <p class="equation-note">{t('equations.local.invite')}</p>
      )}
    </EquationPanel>
  );
}

function noteAt({ phase, iteration }: Frame): string | null {
  if (phase === 'local') return null;
  return phase === 'predict' ? t('equations.local.notYet') : t('equations.local.fromIteration', { iteration });
}

/** The equation with one spring's numbers in the place of its symbols. */
function Substitution({ spring, numbers }: { spring: Spring; numbers: SpringNumbers }) {
  const { p_i, p_j, difference, length, d } = numbers;
  const scale = columnScale(spring.r > 0 ? spring.r : length, 'm');
  const rows: VectorRow[] = [
    { tex: raw`\symp_i`, vector: p_i },
    { tex: raw`\symp_j`, vector: p_j },
    { tex: raw`\symp_i - \symp_j`, vector: difference, withLength: true },
  ];
  if (d) rows.push({ tex: raw`\symd_{ij}`, vector: d, withLength: true });

  return (
    <>
      <p class="equation-facts">
        <strong>{t('equations.local.spring', { index: spring.index })}</strong>
        <span>{t('equations.local.ends', { i: spring.i, j: spring.j })}</span>
        <span>
          r = {formatInColumn(spring.r, scale)} {scale.unit}
        </span>
        <span>{strainText(numbers.strain)}</span>
      </p>
      <VectorTable
        caption={t('equations.local.table', { index: spring.index, unit: scale.unit })}
        scale={scale}
        lengthHeading={t('equations.local.length')}
        rows={rows}
      />
    </>
  );
}
