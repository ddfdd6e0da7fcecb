import { useState } from 'preact/hooks';
import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { pointedJoint } from '../../../app/pointed_joint.ts';
import type { Pose } from '../../../app/pose.ts';
import { formatInColumn } from '../../../lib/format.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { formatDegrees } from './angles.ts';
import { en } from './en.ts';
import { kinematicsFormulas } from './formulas.ts';
import { forwardNumbers } from './forward_numbers.ts';
import { JointTable } from './joint_table.tsx';
import { OneJoint } from './one_joint.tsx';
import { Panel } from './panel.tsx';
import { metres } from './scales.ts';
import { zh } from './zh.ts';

const { raw } = String;

/** Where the joints are, and why: at large for the joint that is pointed at, or else was chosen. */
export function ForwardPanel({ search, pose }: { search: Search; pose: Pose }) {
  const words = inLanguage({ en, zh });
  const [wanted, choose] = useState(1);
  const joints = forwardNumbers(search, pose);
  const last = joints.length - 1;
  const chosen = Math.min(pointedJoint.value ?? wanted, last);
  return (
    <Panel heading={words.forward.heading} lines={[{ formulas: kinematicsFormulas.forward }]}>
      <JointTable
        caption={words.forward.table}
        corner={metres.unit}
        columns={[
          'x',
          'y',
          'z',
          <Formula key="length" tex={raw`\lVert\symo_i\rVert`} />,
          <Formula key="angle" tex={raw`\angle\symq_i`} />,
        ]}
        rows={joints.map(({ x, length, angle }, joint) => ({
          joint,
          cells: [
            ...x.map((value) => formatInColumn(value, metres)),
            length === null ? words.none : formatInColumn(length, metres),
            joint === last ? words.none : `${formatDegrees(angle)}°`,
          ],
        }))}
        chosen={chosen}
        onChoose={choose}
      />
      <OneJoint joint={chosen} joints={joints} />
    </Panel>
  );
}
