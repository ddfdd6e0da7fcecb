import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatVector } from '../../../lib/format.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { VectorTable } from '../../../views/equations/vector_table.tsx';
import type { Moment } from '../trace/moment.ts';
import { formatAngle } from './angles.ts';
import { type CcdNumbers, ccdNumbers } from './ccd_numbers.ts';
import { en } from './en.ts';
import { ErrorFact } from './error_fact.tsx';
import { kinematicsFormulas } from './formulas.ts';
import { jointHooks } from './joint_hooks.ts';
import { jointName } from './joint_name.ts';
import type { MethodPanelProps } from './method_panel.tsx';
import { Panel } from './panel.tsx';
import { finely } from './scales.ts';
import { zh } from './zh.ts';

const { raw } = String;
const { rays, angle, turn } = kinematicsFormulas;

/** Cyclic coordinate descent at the joint that has turned last. */
export function CcdPanel({ search, moment, words: happened, note }: MethodPanelProps) {
  const words = inLanguage({ en, zh });
  const numbers = ccdNumbers(search, moment);
  return (
    <Panel
      heading={words.method.ccd}
      moment={happened}
      lines={[{ formulas: rays }, { formulas: angle }, { formulas: turn }]}
      note={note}
    >
      <p class="equation-note">{words.ccd.rot}</p>
      {numbers && <Turn search={search} moment={moment} numbers={numbers} />}
    </Panel>
  );
}

function Turn({ search, moment, numbers }: { search: Search; moment: Moment; numbers: CcdNumbers }) {
  const words = inLanguage({ en, zh });
  const { joint, toEffector, toTarget, theta, axis, turned, short } = numbers;
  return (
    <div {...jointHooks(joint)}>
      <p class="equation-facts">
        <strong>{jointName(joint, moment.after.x.length / 3)}</strong>
        <span class="arm-angle">
          <Formula tex={raw`\symtheta_{${joint}}`} /> = {formatAngle(theta)}
        </span>
        {axis && <span>{fillTemplate(words.ccd.axis, { axis: formatVector(axis, '').trim() })}</span>}
      </p>
      <VectorTable
        caption={fillTemplate(words.ccd.table, { joint })}
        scale={finely}
        lengthHeading={words.forward.length}
        rows={[
          { tex: raw`\symtoEffector_{${joint}}`, vector: toEffector, withLength: true },
          { tex: raw`\symtoTarget_{${joint}}`, vector: toTarget, withLength: true },
        ]}
      />
      {short && <p class="equation-note">{fillTemplate(words.ccd[short], { angle: formatAngle(turned) })}</p>}
      <ErrorFact search={search} moment={moment} />
    </div>
  );
}
