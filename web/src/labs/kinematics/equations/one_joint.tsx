import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatVector } from '../../../lib/format.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { type VectorRow, VectorTable } from '../../../views/equations/vector_table.tsx';
import { formatAngle, isNoAngle } from './angles.ts';
import { en } from './en.ts';
import { forwardOf } from './formulas.ts';
import type { JointNumbers } from './forward_numbers.ts';
import { jointHooks } from './joint_hooks.ts';
import { jointName } from './joint_name.ts';
import { NumberMatrix } from './number_matrix.tsx';
import { metres, plain } from './scales.ts';
import { zh } from './zh.ts';

const { raw } = String;

/** Forward kinematics with one joint's numbers in the place of its symbols. */
export function OneJoint({ joint, joints }: { joint: number; joints: readonly JointNumbers[] }) {
  const words = inLanguage({ en, zh });
  const { x, link, axis, angle, R } = joints[joint];
  const before = joints[joint - 1];
  const rows: VectorRow[] = [{ tex: raw`\symx_{${joint}}`, vector: x }];
  if (link && before) {
    rows.unshift(
      { tex: raw`\symx_{${joint - 1}}`, vector: before.x },
      { tex: raw`\symR_{${joint - 1}}\symo_{${joint}}`, vector: link, withLength: true },
    );
  }
  return (
    <div class="one-joint" {...jointHooks(joint)}>
      <p class="equation-facts">
        <strong>{jointName(joint, joints.length)}</strong>
        <Formula tex={forwardOf(joint)} />
      </p>
      <VectorTable
        caption={fillTemplate(words.forward.oneJoint, { joint })}
        scale={metres}
        lengthHeading={words.forward.length}
        rows={rows}
      />
      <p class="equation-facts">
        <Formula tex={raw`\symq_{${joint}}`} />
        <span>
          {axis && !isNoAngle(angle)
            ? fillTemplate(words.forward.rotation, { angle: formatAngle(angle), axis: formatVector(axis, '').trim() })
            : words.forward.noRotation}
        </span>
      </p>
      <details>
        <summary>
          <Formula tex={raw`\symR_{${joint}}`} /> {words.forward.matrix}
        </summary>
        <NumberMatrix label={fillTemplate(words.forward.matrixOf, { joint })} rows={R} scale={plain} />
      </details>
    </div>
  );
}
