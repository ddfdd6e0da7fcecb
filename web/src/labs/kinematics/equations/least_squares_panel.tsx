import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { columnScale, formatLength } from '../../../lib/format.ts';
import { norm } from '../../../lib/vector.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { VectorTable } from '../../../views/equations/vector_table.tsx';
import type { Moment } from '../trace/moment.ts';
import { formatDegrees } from './angles.ts';
import { en } from './en.ts';
import { ErrorFact } from './error_fact.tsx';
import { kinematicsFormulas } from './formulas.ts';
import { JointTable } from './joint_table.tsx';
import { leastSquaresNumbers } from './least_squares_numbers.ts';
import type { MethodPanelProps } from './method_panel.tsx';
import { NumberMatrix } from './number_matrix.tsx';
import { Panel } from './panel.tsx';
import { metres } from './scales.ts';
import { zh } from './zh.ts';

const { raw } = String;
const { leastSquares, jacobian } = kinematicsFormulas;

/** Damped least squares at the iteration that was made last. */
export function LeastSquaresPanel({ search, moment, words: happened, note }: MethodPanelProps) {
  const words = inLanguage({ en, zh });
  return (
    <Panel
      heading={words.method['least-squares']}
      moment={happened}
      lines={[{ formulas: leastSquares }, { formulas: jacobian }]}
      note={note}
    >
      <p class="equation-note">{words.leastSquares.axes}</p>
      {moment.kind === 'all' && <Iteration search={search} moment={moment} />}
    </Panel>
  );
}

function Iteration({ search, moment }: { search: Search; moment: Moment }) {
  const words = inLanguage({ en, zh });
  const { missing, promised, moved, turns, columns, share } = leastSquaresNumbers(search, moment);
  const size = norm(missing);
  return (
    <>
      <VectorTable
        caption={words.leastSquares.table}
        scale={columnScale(size, 'm')}
        lengthHeading={words.forward.length}
        rows={[
          { tex: raw`\symmissing`, vector: missing, withLength: true },
          { tex: raw`\symJ\symturn`, vector: promised, withLength: true },
          { tex: raw`\symx_n^{\text{new}} - \symx_n`, vector: moved, withLength: true },
        ]}
      />
      <p class="equation-facts">
        <Formula tex={raw`\symlambda`} />
        <span>
          {share === null
            ? words.leastSquares.unknownDamping
            : fillTemplate(words.leastSquares.damping, {
                lambda: formatLength(Math.sqrt(share) * size),
                share: share >= 1 ? String(share) : `1/${1 / share}`,
              })}
        </span>
      </p>
      <JointTable
        caption={words.leastSquares.turns}
        corner="°"
        columns={['x', 'y', 'z', <Formula key="size" tex={raw`\lVert\symturn_i\rVert`} />]}
        rows={turns.map((turn, joint) => ({ joint, cells: [...turn, norm(turn)].map(formatDegrees) }))}
      />
      <details>
        <summary>
          <Formula tex={raw`\symJ`} /> {fillTemplate(words.leastSquares.matrix, { columns: 3 * columns.length })}
        </summary>
        <NumberMatrix
          label={words.leastSquares.matrixLabel}
          rows={[0, 1, 2].map((axis) => columns.flat().map((column) => column[axis]))}
          scale={metres}
          group={3}
        />
      </details>
      <ErrorFact search={search} moment={moment} />
    </>
  );
}
