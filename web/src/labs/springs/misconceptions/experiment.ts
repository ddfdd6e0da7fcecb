import { labMoment } from '../../../app/lab_moment.ts';
import { reducedMotion } from '../../../app/preferences.ts';
import { findScene } from '../../../app/scene_library.ts';
import type { CommonStart, SideBySide } from '../../../app/side_by_side.ts';
import { parameters as labParameters, pins as labPins, pinsOn } from '../../../app/state.ts';
import type { Scene } from '../../../scene/scene.ts';
import type { Parameters } from '../../../solver/module.ts';
import { sceneParameters } from '../../../solver/scene_parameters.ts';
import type { Variant } from '../../../solver/side_by_side.ts';
import type { Card } from './cards.ts';

/** Vertices: beyond, a factorisation in every iteration, or n² stored zeros, take seconds for a time step. */
export const largestScene = 1200;

/** Which of the two nets makes the mistake. */
export type Order = readonly ['right', 'wrong'] | readonly ['wrong', 'right'];

/**
 * Opens both simulations; they move at once, unless the reader's system asks for less motion.
 * `own`: the lab's scene at its present moment, with its parameters and pins; null for the scene that shows the mistake best, at rest.
 */
export async function openExperiment(
  run: SideBySide,
  card: Card,
  own: Scene | null,
  order: Order,
  isWanted: () => boolean,
): Promise<void> {
  const [start, parameters] = own ? lab(own) : await best(card);
  if (!isWanted()) return;
  const variants = order.map((which): Variant => {
    return { parameters, substeps: 1, mistake: which === 'wrong' ? card.mistake : 'none' };
  });
  const opened = await run.open(variants, start);
  if (opened && isWanted()) run.playing.value = !reducedMotion.value;
}

async function best(card: Card): Promise<[CommonStart, Parameters]> {
  const scene = await findScene(card.scene);
  return [{ scene, pins: pinsOn(scene, null), from: null }, plain(sceneParameters(scene))];
}

function lab(scene: Scene): [CommonStart, Parameters] {
  return [{ scene, pins: labPins.peek(), from: labMoment() }, plain(labParameters.peek())];
}

/** As the solver with the mistake computes: without it, both would make the same bits. */
function plain(parameters: Parameters): Parameters {
  return {
    ...parameters,
    path: 'plain',
    storage: 'sparse',
    method: 'local-global',
    stop_gradient: 0,
    stop_decrease: 0,
  };
}
