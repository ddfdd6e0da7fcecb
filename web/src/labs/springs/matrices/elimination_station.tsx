import { signal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { eliminationRefusal, eliminationStep, eliminations, matrixWishes, noWishes } from '../../../app/matrices.ts';
import { labFigure } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { grouped } from '../../../lib/grouped.ts';
import { symbol } from '../../../notation/symbols.ts';
import type { EliminationStep, Matrices } from '../../../solver/matrices.ts';
import { type Ordering, orderings } from '../../../solver/module.ts';
import { Prose } from '../../../views/equations/prose.tsx';
import { SparsityView } from '../../../views/sparsity/sparsity_view.tsx';
import { Stepper } from '../../../views/stepper/stepper.tsx';
import { listed } from './axes.ts';
import { EliminationTree } from './elimination_tree.tsx';
import { KindLegend } from './kind_legend.tsx';
import { modelOf } from './model_of.ts';
import { type Numbering, numbering } from './numbering.ts';
import { OrderTable } from './order_table.tsx';
import { isFill } from './room_matrices.ts';
import { roomWords } from './room_words.ts';
import { selectThings } from './select_things.ts';

const kinds = ['waiting', 'done', 'fill'] as const;
const colours: Record<(typeof kinds)[number], readonly string[]> = {
  waiting: ['--symbol-other'],
  done: ['--symbol-Q'],
  fill: ['--symbol-d'],
};

const ordering = signal<Ordering>('natural');
const columns = signal(0);

/** Q eliminated column by column, in one of three orders. */
export function EliminationStation({ matrices, actions }: { matrices: Matrices; actions: Actions }) {
  const words = roomWords().elimination;
  const count = matrices.unknowns.length;
  const wanted = Math.min(columns.value, count);
  const order = ordering.value;
  useEffect(() => {
    matrixWishes.value = { ...noWishes, orderings, step: { ordering: order, columns: wanted } };
  }, [order, wanted]);

  const elimination = eliminations.value[order] ?? null;
  const seen = eliminationStep.value;
  const step = seen?.ordering === order ? seen : null;
  const numbered = numbering.value;
  const model = useMemo(
    () => (step && elimination ? modelOfStep(step, elimination.order, numbered) : null),
    [step, elimination, numbered],
  );
  const eliminateTo = (next: number) => {
    columns.value = next;
    if (elimination && next > 0) actions.selectVertex(elimination.order[next - 1]);
  };
  const refusal = eliminationRefusal.value;

  return (
    <div class="elimination">
      <div class="elimination-matrix">
        <Stepper label={words.steps} step={wanted} last={count} onStep={eliminateTo} />
        <p class="elimination-says" role="status" data-testid="elimination">
          {refusal
            ? fillTemplate(words.tooLarge, { flops: formatNumber(refusal.value), limit: formatNumber(refusal.limit) })
            : step && elimination && sayStep(step, elimination.order)}
        </p>
        {model && step && !refusal ? (
          <SparsityView
            figure={labFigure}
            model={model}
            label={fillTemplate(words.matrix, { columns: step.columns, all: count })}
            onSelect={selectThings(actions)}
          >
            <KindLegend kinds={kinds.map((kind) => ({ colours: colours[kind], name: words.kinds[kind] }))} />
          </SparsityView>
        ) : (
          <p class="sparsity matrix-waiting">{!refusal && roomWords().waiting}</p>
        )}
      </div>
      <div class="beside-matrix">
        <Prose text={words.text} />
        <OrderTable
          chosen={order}
          onChoose={(next) => {
            ordering.value = next;
          }}
        />
        {elimination && <EliminationTree elimination={elimination} eliminated={wanted} />}
      </div>
    </div>
  );
}

/** The lower triangle: what is finished, what still waits, and what was not there at first. */
function modelOfStep({ entries, columns: done }: EliminationStep, order: Int32Array, { E }: Numbering) {
  const axis = listed(order);
  return modelOf({
    symbol: 'L',
    triplets: entries,
    rows: axis,
    columns: axis,
    unit: null,
    unitOf: ({ column }) => symbol(column < done ? 'L' : 'Q').unit, // what waits is still a Schur complement of Q
    E,
    kinds: {
      of: (entry) => (isFill(entries, entry) ? 2 : entries.j[entry] < done ? 1 : 0),
      colours: kinds.map((kind) => colours[kind]),
    },
    remark: (entry, pattern) => (entry >= 0 && pattern.kind[entry] === 2 ? roomWords().entry.fill : ''),
  });
}

function sayStep({ entries, columns: done }: EliminationStep, order: Int32Array): string {
  const words = roomWords().elimination;
  if (done === 0) return words.start;
  if (done === order.length) {
    const fill = entries.born.reduce((sum, born) => sum + (born > 0 ? 1 : 0), 0);
    return fillTemplate(words.done, { fill: grouped(fill), count: grouped(entries.born.length) });
  }
  const born = entries.born.reduce((sum, at) => sum + (at === done ? 1 : 0), 0);
  return fillTemplate(words.step, { column: done - 1, vertex: order[done - 1], born });
}
