import { useEffect, useState } from 'preact/hooks';
import type { FigureSession } from './figure_session.ts';
import { type Instant, totalEnergy } from './total_energy.ts';

/** Simulated time, s, and the energy gained since its first point, J. */
export type EnergyCurve = readonly (readonly [time: number, gained: number])[];

/** Kinetic and potential energy of each figure, as far as its time has come. `figures` is to be the same array from render to render. */
export function useEnergies(figures: readonly FigureSession[]): readonly EnergyCurve[] {
  const [energies, setEnergies] = useState<readonly EnergyCurve[]>(figures.map(() => []));

  useEffect(() => {
    let wanted = true;
    const follow = async (figure: FigureSession, at: number) => {
      const instant = settledInstant(figure);
      const inspection = instant && (await figure.inspect([instant.now]));
      if (!wanted || !inspection) return;
      const point = [instant.time, totalEnergy(inspection, instant)] as const;
      setEnergies((curves) =>
        curves.map((curve, index) =>
          index === at ? [...curve.filter(([time]) => time < instant.time), point] : curve,
        ),
      );
    };
    const stops = figures.map((figure, at) => figure.frame.subscribe(() => void follow(figure, at)));
    return () => {
      wanted = false;
      for (const stop of stops) stop();
    };
  }, [figures]);

  return energies.map((curve) => curve.map(([time, energy]) => [time, energy - curve[0][1]] as const));
}

/** Of positions that are settled, the latest: those that the time step starts from or, once it is accepted, ends with. */
export function settledInstant(figure: FigureSession): Instant | null {
  const here = figure.checkpoint();
  const frame = figure.frame.value;
  if (!here || !frame) return null;
  const { delta_t } = figure.parameters.value;
  return frame.phase === 'accept'
    ? { time: here.step * delta_t, delta_t, now: frame.p, before: here.p_curr }
    : { time: (here.step - 1) * delta_t, delta_t, now: here.p_curr, before: here.p_prev };
}
