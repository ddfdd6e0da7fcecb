import { type ComparedParameter, comparedLimits } from '../../app/integrators.ts';

/** What a slider reaches from a scene's own value: far enough to see what the number does, not so far that nothing else is seen. */
const factors: Record<ComparedParameter, readonly [down: number, up: number]> = {
  k: [1 / 10, 10],
  mass_scale: [1 / 10, 10],
  delta_t: [1 / 10, 10],
  damping: [1 / 2, 50], // the cloth's 0.2 N·s/m from 0.1 to 10
  gravity: [1 / 10, 10],
};

/** Where the scene has none, so that the slider begins with 0. */
const mostFromNone = { damping: 100, gravity: 10 } as const;

export function reachOf(name: ComparedParameter, own: number): { min: number; max: number } {
  const { min, max } = comparedLimits[name];
  if (own === 0 && (name === 'damping' || name === 'gravity')) return { min: 0, max: mostFromNone[name] };
  const [down, up] = factors[name];
  return { min: Math.max(min, down * own), max: Math.min(max, up * own) };
}
