import type { Search } from '../../../app/kinematics_session.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import type { IkMethod } from '../../../solver/inverse_kinematics.ts';
import type { Moment } from '../trace/moment.ts';
import { momentText } from '../trace/moment_text.ts';
import { CcdPanel } from './ccd_panel.tsx';
import { en } from './en.ts';
import { passRows } from './fabrik_numbers.ts';
import { FabrikPanel } from './fabrik_panel.tsx';
import { LeastSquaresPanel } from './least_squares_panel.tsx';
import { zh } from './zh.ts';

export interface MethodPanelProps {
  search: Search;
  moment: Moment;
  /** The moment in words. */
  words: string;
  /** About an event that is no step of the method; null for one that is. */
  note: string | null;
}

const panels: Record<IkMethod, (props: MethodPanelProps) => preact.JSX.Element> = {
  ccd: CcdPanel,
  fabrik: FabrikPanel,
  'least-squares': LeastSquaresPanel,
};

/** What the method has just done. */
export function MethodPanel({ search, moment }: { search: Search; moment: Moment }) {
  const { notes } = inLanguage({ en, zh });
  const Shown = panels[search.task.method];
  const about = noteOf(search, moment);
  return <Shown search={search} moment={moment} words={momentText(search, moment)} note={about && notes[about]} />;
}

/** What is to be said about an event that is no step of the method. */
function noteOf({ task }: Search, moment: Moment) {
  switch (moment.kind) {
    case 'start':
    case 'bend':
      return moment.kind;
    case 'straight':
      return task.turn_limit < Math.PI ? 'straightened' : 'straight';
    case 'limit':
      return isHeld(moment) ? 'limit' : 'within';
    default:
      return null;
  }
}

/** rad: what single precision may turn where no limit does. */
const rounding = 1e-5;

/** Whether limits have turned any joint back. */
function isHeld(moment: Moment): boolean {
  return passRows(moment).some(({ turned }) => turned !== null && turned > rounding);
}
