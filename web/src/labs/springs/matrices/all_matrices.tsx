import { signal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { eliminations, linearlyImplicit, matrixWishes, noWishes } from '../../../app/matrices.ts';
import { t } from '../../../app/messages/index.ts';
import { labFigure } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber, formatQuantity } from '../../../lib/format.ts';
import { grouped } from '../../../lib/grouped.ts';
import type { Elimination, Matrices } from '../../../solver/matrices.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { SparsityThumb } from '../../../views/sparsity/sparsity_thumb.tsx';
import { SparsityView } from '../../../views/sparsity/sparsity_view.tsx';
import { KindLegend } from './kind_legend.tsx';
import { numbering } from './numbering.ts';
import { type MatrixName, matrixNames, roomMatrices } from './room_matrices.ts';
import { roomWords } from './room_words.ts';
import { selectThings } from './select_things.ts';

const { raw } = String;

const formulas: Record<MatrixName, string> = {
  A: raw`\symA`,
  M: raw`\symM`,
  C: raw`\symC`,
  AtA: raw`\symA^{\mathrm T}\symA`,
  Q: raw`\symQ`,
  L: raw`\symL`,
  P: raw`\symP`,
  K: raw`\symK`,
  implicit: raw`\symM - \symdeltaT^2\symK`,
  Phat: raw`\symPhat`,
};

const chosen = signal<MatrixName>('A');

/** Every matrix small, and one of them large. */
export function AllMatrices({ matrices, actions }: { matrices: Matrices; actions: Actions }) {
  const words = roomWords().all;
  const numbered = numbering.value;
  const elimination = eliminations.value.solver ?? null;
  const implicit = linearlyImplicit.value;
  const models = useMemo(
    () => roomMatrices(matrices, elimination, implicit, numbered),
    [matrices, elimination, implicit, numbered],
  );
  useEffect(() => {
    matrixWishes.value = { ...noWishes, orderings: ['solver'], linearlyImplicit: true };
  }, []);
  const name = chosen.value;
  const model = models[name];
  return (
    <div class="all-matrices">
      <fieldset class="matrix-picker" aria-label={words.choose}>
        {matrixNames.map((id) => (
          <button
            key={id}
            type="button"
            aria-pressed={id === name}
            onClick={() => {
              chosen.value = id;
            }}
          >
            <SparsityThumb model={models[id]} />
            <span>
              <Formula tex={formulas[id]} /> <span class="visually-hidden">{nameOf(id)}</span>
            </span>
          </button>
        ))}
      </fieldset>
      <div class="beside-matrix">
        <p>
          <strong class="matrix-name">{nameOf(name)}.</strong>{' '}
          {name === 'AtA' || name === 'implicit' ? words[name].meaning : t(`symbols.meaning.${name}`)}
        </p>
        <KindLegend
          kinds={
            name === 'L'
              ? [
                  { colours: ['--symbol-Q'], name: words.entry },
                  { colours: ['--symbol-d'], name: words.fill },
                ]
              : ['A', 'AtA', 'Q', 'K', 'implicit'].includes(name)
                ? [
                    { colours: ['--symbol-Q'], name: words.signs.positive },
                    { colours: ['--sparsity-negative'], name: words.signs.negative },
                  ]
                : []
          }
        />
        <p class="aside">{factsOf(name, models, elimination, matrices)}</p>
      </div>
      {model && (
        <SparsityView
          figure={labFigure}
          model={model}
          label={`${nameOf(name)}, ${model.pattern.rows} × ${model.pattern.columns}`}
          onSelect={selectThings(actions)}
        />
      )}
    </div>
  );
}

function nameOf(name: MatrixName): string {
  return name === 'AtA' || name === 'implicit' ? roomWords().all[name].name : t(`symbols.name.${name}`);
}

function factsOf(
  name: MatrixName,
  models: ReturnType<typeof roomMatrices>,
  elimination: Elimination | null,
  { unknowns, Q }: Matrices,
): string {
  const words = roomWords().all;
  const model = models[name];
  if (!model)
    return name === 'L' && elimination
      ? fillTemplate(words.tooLarge, {
          flops: formatNumber(elimination.flops),
          count: grouped(elimination.nonzeros),
        })
      : roomWords().waiting;
  const { rows, columns, value } = model.pattern;
  const all = rows * columns;
  const count = value.reduce((sum, entry) => sum + (entry === 0 ? 0 : 1), 0);
  const size = fillTemplate(words.size, {
    rows: grouped(rows),
    columns: grouped(columns),
    count: grouped(count),
    all: grouped(all),
    share: formatQuantity(all === 0 ? 0 : (100 * count) / all, '%', 2),
  });
  if (name === 'K' || name === 'implicit') return `${size} ${words.coordinates}`;
  const ofFree = (name === 'L' || name === 'P') && unknowns.length < Q.rows;
  return ofFree ? `${size} ${fillTemplate(words.free, { count: unknowns.length })}` : size;
}
