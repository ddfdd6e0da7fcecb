import { signal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { linearlyImplicit, matrixWishes, noWishes } from '../../../app/matrices.ts';
import { labFigure, parameters, playing } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { grouped } from '../../../lib/grouped.ts';
import type { LinearlyImplicitMatrices, Matrices } from '../../../solver/matrices.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { Prose } from '../../../views/equations/prose.tsx';
import { SparsityView } from '../../../views/sparsity/sparsity_view.tsx';
import { Stepper } from '../../../views/stepper/stepper.tsx';
import { byCoordinates, listed, numbered } from './axes.ts';
import { BesideQ } from './beside_q.tsx';
import './implicit_station.css';
import { KindLegend } from './kind_legend.tsx';
import { modelOf } from './model_of.ts';
import { freeVertices, numbering } from './numbering.ts';
import { roomWords } from './room_words.ts';
import { selectThings } from './select_things.ts';
import { signKinds } from './sign_kinds.ts';
import { SpringBlock } from './spring_block.tsx';
import { constrainedTo, placesOfSprings, sumOfSprings } from './sum_of_springs.ts';
import { type Stage, stages, summandsOf } from './summands_of.ts';

const { raw } = String;

const formulas: Record<Stage, string> = {
  K: raw`\symK`,
  system: raw`\symM - \symdeltaT^2\symK`,
  constrained: raw`\symPhat(\symM - \symdeltaT^2\symK)\symPhat^{\mathrm T}`,
};

/** By sign, and the last spring's four blocks by one colour. */
const latest = signKinds.colours.length;
const kinds = { ...signKinds, colours: [...signKinds.colours, ['--accent']] };

const stage = signal<Stage>('K');
const added = signal(1);

/** The matrix of linearly implicit Euler, made of springs, masses and the choice of free vertices; and what it costs beside Q. */
export function ImplicitStation({ matrices, actions }: { matrices: Matrices; actions: Actions }) {
  const words = roomWords().implicit;
  useEffect(() => {
    matrixWishes.value = { ...noWishes, linearlyImplicit: true };
  }, []);
  const read = linearlyImplicit.value;
  return (
    <div class="implicit">
      {read ? (
        <Assembly read={read} matrices={matrices} actions={actions} />
      ) : (
        <p class="matrix-waiting">{playing.value ? roomWords().paused : roomWords().waiting}</p>
      )}
      <div class="beside-matrix">
        <Prose text={words.text} />
        {read && <SpringBlock read={read} stage={stage.value} count={Math.min(added.value, springCount())} />}
        {read && <BesideQ read={read} Q={matrices.Q} />}
      </div>
    </div>
  );
}

function springCount(): number {
  return numbering.value.E.length / 2;
}

interface Props {
  read: LinearlyImplicitMatrices;
  matrices: Matrices;
  actions: Actions;
}

/** The matrix so far, and how far that is. */
function Assembly({ read, matrices: { M }, actions }: Props) {
  const words = roomWords().implicit;
  const shown = stage.value;
  const numbered = numbering.value;
  const all = springCount();
  const count = Math.min(added.value, all);
  const { delta_t } = parameters.value;
  const places = useMemo(() => placesOfSprings(read.system, numbered.E), [read.system, numbered]);
  const summands = useMemo(() => summandsOf(shown, read, M.value, delta_t), [shown, read, M, delta_t]);
  const model = useMemo(
    () => modelOfSum(shown, sumOfSprings({ ...summands, matrix: read.system, places }, count), numbered),
    [shown, summands, read.system, places, count, numbered],
  );
  const addUpTo = (next: number) => {
    added.value = next;
    if (next > 0) actions.selectSpring(next - 1);
  };
  return (
    <div class="implicit-matrix">
      <fieldset class="implicit-stages" aria-label={words.matrix}>
        {stages.map((id) => (
          <button
            key={id}
            type="button"
            aria-pressed={id === shown}
            onClick={() => {
              stage.value = id;
            }}
          >
            <Formula tex={formulas[id]} />
            <span>{words.stages[id]}</span>
          </button>
        ))}
      </fieldset>
      <Stepper label={words.steps} step={count} last={all} onStep={addUpTo} />
      <SparsityView
        figure={labFigure}
        model={model}
        label={fillTemplate(words.label[shown], { count: grouped(count), all: grouped(all) })}
        onSelect={selectThings(actions)}
      >
        <KindLegend
          kinds={[
            { colours: ['--accent'], name: words.kinds.latest },
            { colours: ['--symbol-Q'], name: words.kinds.positive },
            { colours: ['--sparsity-negative'], name: words.kinds.negative },
            { colours: ['--muted'], name: words.kinds.zero },
          ]}
        />
      </SparsityView>
    </div>
  );
}

function modelOfSum(
  shown: Stage,
  sum: ReturnType<typeof sumOfSprings>,
  { E, vertexCount, pinned }: typeof numbering.value,
) {
  const free = shown === 'constrained' ? freeVertices({ vertexCount, pinned }) : null;
  const soFar = free ? constrainedTo(free, sum) : sum;
  const axis = byCoordinates(free ? listed(free) : numbered('vertex', vertexCount));
  return modelOf({
    E,
    symbol: 'K',
    triplets: soFar.sum,
    rows: axis,
    columns: axis,
    unit: shown === 'K' ? 'N/m' : 'kg',
    kinds: {
      of: (entry, value) => (soFar.latest[entry] ? latest : signKinds.of(entry, value)),
      colours: kinds.colours,
    },
  });
}
