import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { columnScale, formatInColumn, formatLength } from '../../../lib/format.ts';
import type { Moment } from '../trace/moment.ts';
import { formatDegrees } from './angles.ts';
import { en } from './en.ts';
import { ErrorFact } from './error_fact.tsx';
import { passRows, rootGap } from './fabrik_numbers.ts';
import { kinematicsFormulas } from './formulas.ts';
import { JointTable } from './joint_table.tsx';
import type { MethodPanelProps } from './method_panel.tsx';
import { Panel } from './panel.tsx';
import { metres } from './scales.ts';
import { zh } from './zh.ts';

const { backward, forwardPass, rotations } = kinematicsFormulas;

/** Forward and backward reaching: both passes, and what the last one did with each joint. */
export function FabrikPanel({ search, moment, words: happened, note }: MethodPanelProps) {
  const words = inLanguage({ en, zh });
  const { kind } = moment;
  return (
    <Panel
      heading={words.method.fabrik}
      moment={happened}
      lines={[
        { formulas: backward, label: words.fabrik.backward, active: kind === 'backward' },
        { formulas: forwardPass, label: words.fabrik.forward, active: kind === 'forward' },
        { formulas: rotations, label: words.fabrik.rotations, active: kind === 'forward' },
      ]}
      note={note}
    >
      {(kind === 'backward' || kind === 'forward' || kind === 'limit') && <Pass moment={moment} kind={kind} />}
      {kind === 'backward' && (
        <p class="equation-facts">
          {fillTemplate(words.fabrik.rootGap, { length: formatLength(rootGap(search, moment)) })}
        </p>
      )}
      {(kind === 'forward' || kind === 'limit') && <ErrorFact search={search} moment={moment} />}
    </Panel>
  );
}

/** m: a move that is shown; what is less is mostly rounding. */
const least = 1e-6;

function Pass({ moment, kind }: { moment: Moment; kind: 'backward' | 'forward' | 'limit' }) {
  const words = inLanguage({ en, zh });
  const rows = passRows(moment);
  const turns = kind !== 'backward';
  const scale = columnScale(Math.max(least, ...rows.map(({ moved }) => moved)), 'm', 3);
  return (
    <JointTable
      caption={words.fabrik[kind]}
      corner={metres.unit}
      columns={[
        'x',
        'y',
        'z',
        fillTemplate(words.fabrik.moved, { unit: scale.unit }),
        ...(turns ? [words.fabrik.turned] : []),
      ]}
      rows={rows.map(({ joint, x, moved, turned }) => ({
        joint,
        cells: [
          ...x.map((value) => formatInColumn(value, metres)),
          formatInColumn(moved, scale),
          ...(turns ? [turned === null ? words.none : `${formatDegrees(turned)}°`] : []),
        ],
      }))}
    />
  );
}
