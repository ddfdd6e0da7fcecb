import type { EnergySample } from '../../app/side_by_side_record.ts';

/** s of simulated time that the charts show. */
export const shownTime = 10;

/** s of simulated time over which a loss or gain is told. */
const told = 1;

/** Time steps between two drawn points are so many that a curve has no more points than this. */
const mostPoints = 240;

/** J. */
export function total({ kinetic, springs, external }: EnergySample): number {
  return kinetic + springs + external;
}

/**
 * W: the slope of the straight line that fits the total energy best, of the last second or since something was changed; null while that is too
 * little to say.
 */
export function energyRate(samples: readonly EnergySample[]): number | null {
  const { time: end, stretch: now } = samples.at(-1) ?? { time: 0, stretch: 0 };
  const last = samples.filter(({ time, stretch }) => time > end - told && stretch === now);
  if (last.length < 3) return null;
  const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const times = last.map(({ time }) => time);
  const totals = last.map(total);
  const [t, E] = [mean(times), mean(totals)];
  const covariance = mean(times.map((time, at) => (time - t) * (totals[at] - E)));
  return covariance / mean(times.map((time) => (time - t) ** 2));
}

/** Those of the last seconds, as many as can be told apart: always the same time steps, so that a curve does not flicker while it grows. */
export function shownSamples(samples: readonly EnergySample[]): EnergySample[] {
  const end = samples.at(-1)?.time ?? 0;
  const late = samples.filter(({ time }) => time > end - shownTime);
  const stride = 2 ** Math.ceil(Math.log2(Math.max(1, late.length / mostPoints)));
  return late.filter(({ step }, at) => step % stride === 0 || at === late.length - 1);
}

/**
 * Where one method explodes, its curve would press all others flat: the frame is then made for those whose energy varies no more than so many times
 * as much as the quietest one's. Undefined where nothing explodes.
 */
export function calmRange(curves: readonly (readonly number[])[]): readonly [min: number, max: number] | undefined {
  const extents = curves.map((values) => {
    const [least, most] = [Math.min(...values), Math.max(...values)];
    return { least, most, extent: most - least };
  });
  const moving = extents.filter(({ extent }) => extent > 0);
  const quietest = Math.min(...moving.map(({ extent }) => extent));
  const calm = moving.filter(({ extent }) => extent <= wildest * quietest);
  if (calm.length === moving.length) return undefined;
  const [least, most] = [Math.min(...calm.map((one) => one.least)), Math.max(...calm.map((one) => one.most))];
  const room = most - least;
  return [least - room / 2, most + room / 2];
}

const wildest = 50;
