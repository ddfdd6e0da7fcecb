import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { pathOf } from '../../../../app/route.ts';
import { CodeListing } from '../../../../views/code/code_listing.tsx';
import type { SourceFile } from '../../../../views/code/sources.ts';
import { Deferred } from '../../../../views/deferred/deferred.tsx';
import { Display } from '../../../../views/equations/display.tsx';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import { moves } from '../../figures/arrows.ts';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { InSlices } from '../../in_slices.tsx';
import { Sources } from '../../sources.tsx';
import { en } from './en.ts';
import { zh } from './zh.ts';
import './tasks.css';

const { raw } = String;

const halfSteps: FigureSettings = {
  scene: 'triangle',
  parameters: { iterations: 4 },
  selection: { spring: 1, vertex: 2 },
  opening: [{ kind: 'play', steps: 3 }, { kind: 'next_half_step' }],
};
const damped: FigureSettings = {
  scene: 'single-spring-horizontal',
  parameters: { iterations: 1, k: 1000 },
  selection: { spring: 0, vertex: 1 },
};

/** Nets in space: their code comes when an answer is looked at. */
const experiments = {
  k: async () => (await import('./mistaken_nets.tsx')).ForgottenK,
  order: async () => (await import('./mistaken_nets.tsx')).SwappedTimes,
  slow: async () => (await import('./mistaken_nets.tsx')).Slowly,
};
const others = ['k', 'order', 'slow'] as const;

interface Task {
  id: keyof typeof en.tasks;
  formulas: readonly string[];
  files: readonly SourceFile[];
}

const system = raw`\symQ = \symk\symA^{\mathrm T}\symA + \tfrac{1}{\symdeltaT^2}\symM + \symw\symC^{\mathrm T}\symC`;

const tasks: readonly Task[] = [
  {
    id: 'lengths',
    formulas: [raw`\symr_{ij} = \lVert \symV_i - \symV_j \rVert`],
    files: ['edge_lengths.cpp', 'edge_vectors.cpp'],
  },
  {
    id: 'incidence',
    formulas: [raw`(\symA\symp)_{ij} = \symp_i - \symp_j`],
    files: ['signed_incidence_matrix.cpp', 'matrix_from_triplets.cpp'],
  },
  {
    id: 'precomputation',
    formulas: [system],
    files: ['fast_mass_springs_precomputation_dense.cpp', 'system_matrix.cpp', 'dense_cholesky.cpp'],
  },
  {
    id: 'step',
    formulas: [
      raw`\begin{aligned} \symy = {} & \tfrac{1}{\symdeltaT^2}\symM(2\sympCurr - \sympPrev) \\ & + \symfExt + \symw\symC^{\mathrm T}\symC\,\sympTarget \end{aligned}`,
      raw`\symd_{ij} = \symr_{ij}\,\frac{\symp_i - \symp_j}{\lVert \symp_i - \symp_j \rVert}`,
      raw`\symQ\symp = \symb, \quad \symb = \symk\symA^{\mathrm T}\symd + \symy`,
    ],
    files: [
      'fast_mass_springs_step.h',
      'inertial_right_hand_side.cpp',
      'local_step.cpp',
      'right_hand_side.cpp',
      'global_step.cpp',
    ],
  },
  { id: 'sparseIncidence', formulas: [], files: ['signed_incidence_matrix.cpp', 'matrix_from_triplets.cpp'] },
  {
    id: 'sparsePrecomputation',
    formulas: [system],
    files: ['fast_mass_springs_precomputation_sparse.cpp', 'system_matrix.cpp', 'sparse_cholesky.cpp'],
  },
  { id: 'sparseStep', formulas: [], files: ['fast_mass_springs_step.h'] },
];

export function Tasks() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(halfSteps);
  const { damped: tooFew } = words.mistakes;
  return (
    <InSlices>
      <Prose text={words.intro} />
      <Figure figure={figure} pictures={['torn', 'net']} arrows={moves} caption={words.caption} />
      {tasks.map(({ id, formulas, files }, at) => (
        <section key={id} class="task">
          <h3>
            {at + 1}. <code>{words.tasks[id].title}</code>
          </h3>
          <Prose text={words.tasks[id].text} />
          {formulas.map((tex) => (
            <Display key={tex} tex={tex} />
          ))}
          <Listings summary={words.open} files={files} />
        </section>
      ))}
      <Question ask={tooFew.ask} hint={tooFew.hint} answer={tooFew.answer}>
        <Damped caption={tooFew.caption} />
      </Question>
      {others.map((id) => (
        <Question key={id} {...words.mistakes[id]}>
          <p class="figure-note">{words.nets.captions[id]}</p>
          <div class="mistaken-nets-room">
            <Deferred load={experiments[id]} />
          </div>
        </Question>
      ))}
      <p>
        <a href={pathOf({ page: 'springs', room: 'misconceptions' })}>{words.cabinet}</a>
      </p>
      <Sources items={words.sources} />
    </InSlices>
  );
}

/** The solver's own files, folded away until the reader has tried. */
function Listings({ summary, files }: { summary: string; files: readonly SourceFile[] }) {
  const [shown, show] = useState(false);
  return (
    <details class="task-code" onToggle={(event) => show(event.currentTarget.open)}>
      <summary>{summary}</summary>
      {shown && files.map((file) => <CodeListing key={file} file={file} />)}
    </details>
  );
}

function Damped({ caption }: { caption: string }) {
  const figure = useFigure(damped);
  return <Figure figure={figure} pictures={['net']} sliders={['iterations', 'k']} caption={caption} />;
}
