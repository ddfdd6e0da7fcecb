import { inLanguage } from '../../../../app/messages/in_language.ts';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import type { AtPoint } from '../../gradient_check.tsx';
import { InSlices } from '../../in_slices.tsx';
import { RoomLink } from '../../room_link.tsx';
import { Slip } from '../../slip.tsx';
import { Sources } from '../../sources.tsx';
import { ChangeCounters } from './change_counters.tsx';
import { Eliminated } from './eliminated.tsx';
import { en } from './en.ts';
import { FittingProduct } from './fitting_product.tsx';
import { printedPinEnergy } from './printed_pin_energy.ts';
import { SelectedRows } from './selected_rows.tsx';
import { WeakPin } from './weak_pin.tsx';
import { zh } from './zh.ts';
import './pins.css';

const penalised: FigureSettings = {
  scene: 'triangle',
  parameters: { w: 1e3 },
  selection: { spring: 0, vertex: 1 },
  opening: [{ kind: 'play', steps: 3 }],
};

export function Pins() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(penalised);
  return (
    <InSlices>
      <Prose text={words.intro} />
      <h3>{words.weak.title}</h3>
      <Prose text={words.weak.text} />
      <WeakPin figure={figure} caption={words.caption} words={words.weak} />
      <h3>{words.elimination.title}</h3>
      <Prose text={words.elimination.text} />
      <Eliminated words={words.elimination} />
      <Question ask={words.every.ask} hint={words.every.hint} answer={words.every.answer}>
        <SelectedRows caption={words.every.caption} />
      </Question>
      <Question ask={words.product.ask} hint={words.product.hint} answer={words.product.answer}>
        <FittingProduct words={words.product} />
      </Question>
      <Question ask={words.again.ask} hint={words.again.hint} answer={words.again.answer}>
        <ChangeCounters words={words.again} />
      </Question>
      <Slip
        figure={figure}
        printed={words.slip.printed}
        right={words.slip.right}
        why={words.slip.why}
        printedEnergy={(at: AtPoint) => printedPinEnergy(at, figure.scene.value.V)}
      />
      <RoomLink room="matrices" />
      <Sources items={words.sources} />
    </InSlices>
  );
}
