import type { SolverClient } from '../solver/client.ts';
import type { Actions } from './actions.ts';
import { Obstacle } from './obstacle.ts';
import { reducedMotion } from './preferences.ts';
import { requireWebGL } from './require_webgl.ts';
import { startSolver } from './start_solver.ts';
import { defaultState, frame, state } from './state.ts';

/** Makes the lab's solver ready and opens the scene that the state names, unless one is open. Throws Obstacle when the lab cannot run here. */
export async function startLab(client: SolverClient, actions: Actions): Promise<void> {
  requireWebGL();
  await startSolver(client);
  if (frame.value) return;
  const { language, theme } = state.value;
  const opened = (await actions.restore(state.value)) || (await actions.restore({ ...defaultState, language, theme }));
  if (!opened) throw new Obstacle('page.errors.noScene');
  if (!reducedMotion.value) actions.play();
}
