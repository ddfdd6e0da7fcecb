import type { KinematicsSession, Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { momentAt } from '../trace/moment.ts';
import { en } from './en.ts';
import { ForwardPanel } from './forward_panel.tsx';
import { MethodPanel } from './method_panel.tsx';
import { zh } from './zh.ts';
import './equations.css';

/** What the arm's numbers come from, at the place of the cursor. */
export function Equations({ session }: { session: KinematicsSession }) {
  const words = inLanguage({ en, zh });
  const search = session.search.value as Search; // the lab is shown once there is one
  const moment = momentAt(search, session.event.value);
  return (
    <section class="arm-equations" aria-label={words.heading}>
      <MethodPanel search={search} moment={moment} />
      <ForwardPanel search={search} pose={moment.after} />
    </section>
  );
}
