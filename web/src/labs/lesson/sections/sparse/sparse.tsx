import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import type { Frame } from '../../../../solver/frame.ts';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import type { Arrows } from '../../figures/arrows.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { useInspection } from '../../figures/use_inspection.ts';
import { InSlices } from '../../in_slices.tsx';
import { RoomLink } from '../../room_link.tsx';
import { Sources } from '../../sources.tsx';
import { smallMatrix } from '../solving/small_matrix.ts';
import { assembled, type Repetition, tripletsOfQ, withZeros } from './assembly.ts';
import { en } from './en.ts';
import { EntryCounts } from './entry_counts.tsx';
import { FillFigure } from './fill_figure.tsx';
import { FlagExperiment } from './flag_experiment.tsx';
import { GlobalStepReport } from './global_step_report.tsx';
import { globalStepWith } from './global_step_with.ts';
import { InsertionExperiment } from './insertion_experiment.tsx';
import './sparse.css';
import { TripletsFigure } from './triplets_figure.tsx';
import { zh } from './zh.ts';

/** A penalty small enough for its entries to be read beside the others. At the global half-step, so that p solves Q p = b. */
const assembling: FigureSettings = {
  scene: 'square',
  parameters: { w: 1000, iterations: 4 },
  selection: { spring: null, vertex: 2 },
  opening: [
    { kind: 'play', steps: 3 },
    { kind: 'next_half_step' },
    { kind: 'next_half_step' },
    { kind: 'next_half_step' },
  ],
};

export function Sparse() {
  const words = inLanguage({ en, zh });
  return (
    <InSlices>
      <Prose text={words.which} />
      <EntryCounts />
      <Prose text={words.list} />
      <Assembling />
      <Prose text={words.overwriting} />
      <Question {...words.entryByEntry}>
        <InsertionExperiment />
      </Question>
      <Question {...words.slowFlag}>
        <FlagExperiment />
      </Question>
      <h3>{words.fillTitle}</h3>
      <Prose text={words.fillIn} />
      <FillFigure />
      <RoomLink room="matrices" />
      <Sources items={words.sources} />
    </InSlices>
  );
}

function Assembling() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(assembling);
  const seen = useInspection(figure);
  const [inserted, setInserted] = useState(0);
  const [repetition, setRepetition] = useState<Repetition>('add');
  const { E, m, pinned } = figure.scene.value;
  const triplets = tripletsOfQ({ E, m }, pinned, figure.parameters.value);
  const insert = (count: number) => {
    setInserted(count);
    const from = triplets[count - 1]?.from;
    figure.selection.value = {
      spring: from?.kind === 'spring' ? from.index : null,
      vertex: from && from.kind !== 'spring' ? from.index : null,
    };
  };
  const complete = inserted === triplets.length;
  const step = seen && complete ? globalStepWith(withZeros(assembled(m.length, triplets, repetition)), seen) : null;
  const arrows = ({ p }: Frame): Arrows => ({ from: p, to: step && 'p' in step ? step.p : p, symbol: 'p' });
  return (
    <Figure figure={figure} pictures={['net']} arrows={arrows} sliders={['k']} caption={words.triplets.caption}>
      <TripletsFigure
        figure={figure}
        triplets={triplets}
        inserted={Math.min(inserted, triplets.length)}
        onInsert={insert}
        repetition={repetition}
        onRepetition={setRepetition}
      />
      {step && seen && <GlobalStepReport step={step} right={globalStepWith(smallMatrix(seen.Q), seen)} />}
    </Figure>
  );
}
