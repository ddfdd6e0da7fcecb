import { type ComparedParameter, comparedLimits } from '../../app/integrators.ts';

/** What a slider reaches from a scene's own value: far enough to see what the number does, not so far that nothing else is seen. */
const factors: Record<ComparedParameter, readonly [down: number, up: number]> = {
  k: [1 / 10, 10],
  mass_scale: [1 / 10, 10],
  delta_t: [1 / 10, 10],
  damping: [1 / 10, 50],
  gravity: [1 / 10, 10],
};

/** Where the scene has none, so that the slider begins with 0. */
const mostFromNone = { damping: 100, gravity: 10 } as const;

interface Reach {
  min: number;
  max: number;
}

/** The sliders of the cloth lab ([P]), whose vertices weigh 1 kg; it has none for the time step. */
const clothLab: Partial<Record<ComparedParameter, Reach>> = {
  k: { min: 10, max: 300 },
  mass_scale: { min: 0.5, max: 10 },
  damping: { min: 0.1, max: 10 },
  gravity: { min: 0.1, max: 1 },
};

/** @param own  the scene's own value */
export function reachOf(scene: string, name: ComparedParameter, own: number): Reach {
  const asInTheLab = scene === 'cloth' ? clothLab[name] : undefined;
  if (asInTheLab) return asInTheLab;
  const { min, max } = comparedLimits[name];
  if (own === 0 && (name === 'damping' || name === 'gravity')) return { min: 0, max: mostFromNone[name] };
  const [down, up] = factors[name];
  return { min: Math.max(min, down * own), max: Math.min(max, up * own) };
}
