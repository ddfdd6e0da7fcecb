import { useEffect } from 'preact/hooks';
import { matrixWishes, noWishes, storageComparison } from '../../../app/matrices.ts';
import { parameters } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { formatBytes } from '../../../lib/format_bytes.ts';
import { formatTime } from '../../../lib/format_time.ts';
import { grouped } from '../../../lib/grouped.ts';
import type { StorageCost } from '../../../solver/matrices.ts';
import { Prose } from '../../../views/equations/prose.tsx';
import { type DenseCall, extrapolated, largest } from './dense_growth.ts';
import { DenseLimits } from './dense_limits.tsx';
import { roomWords } from './room_words.ts';
import { useNetTimes } from './use_net_times.ts';

const costs = ['bytesOfQ', 'bytesOfL', 'factorise', 'substitute', 'step'] as const;
type Cost = (typeof costs)[number];

/** What the zeros cost: dense against sparse storage of the present scene, and where dense stops being sensible. */
export function Storage() {
  const words = roomWords().storage;
  const nets = useNetTimes();
  useEffect(() => {
    matrixWishes.value = { ...noWishes, storage: true };
  }, []);
  const compared = storageComparison.value;
  const { iterations } = parameters.value;

  /** Where dense was not tried, what it would take as far as the nets can tell. */
  const guess = (cost: Cost): number | null => {
    const call: DenseCall = cost === 'factorise' ? 'dense_factorise' : 'dense_substitute';
    const measured = largest(nets.times, call);
    return compared && measured && extrapolated(measured, compared.n) * (cost === 'step' ? iterations : 1);
  };

  return (
    <div class="storage">
      <Prose text={words.text} />
      {compared ? (
        <table class="numbers" data-testid="storage">
          <caption>{fillTemplate(words.caption, { n: grouped(compared.n), iterations })}</caption>
          <thead>
            <tr>
              <td />
              <th scope="col">{words.dense}</th>
              <th scope="col">{words.sparse}</th>
              <th scope="col">{words.ratio}</th>
            </tr>
          </thead>
          <tbody>
            {costs.map((cost) => {
              const dense = costOf(compared.dense, cost, iterations);
              const sparse = costOf(compared.sparse, cost, iterations);
              const likely = dense ?? guess(cost);
              return (
                <tr key={cost} data-cost={cost}>
                  <th scope="row">{words.rows[cost]}</th>
                  <td>
                    {dense === null && likely !== null
                      ? fillTemplate(words.extrapolated, { time: written(cost, likely) })
                      : written(cost, dense)}
                  </td>
                  <td>{written(cost, sparse)}</td>
                  <td class="aside">{likely !== null && sparse ? `${formatNumber(likely / sparse, 2)} : 1` : '–'}</td>
                </tr>
              );
            })}
          </tbody>
        </table>
      ) : (
        <p class="aside">{words.measuring}</p>
      )}
      {compared && compared.n > compared.largestDense && (
        <p class="aside">{fillTemplate(words.limits.estimated, { largest: grouped(compared.largestDense) })}</p>
      )}
      <DenseLimits {...nets} n={compared?.n ?? null} />
    </div>
  );
}

function costOf(storage: StorageCost, cost: Cost, iterations: number): number | null {
  if (cost !== 'step') return storage[cost];
  return storage.substitute === null ? null : iterations * storage.substitute;
}

function written(cost: Cost, value: number | null): string {
  if (value === null) return '…';
  return cost === 'bytesOfQ' || cost === 'bytesOfL' ? formatBytes(value) : formatTime(value, 2);
}
