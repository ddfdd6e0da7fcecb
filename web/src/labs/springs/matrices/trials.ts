import { newSolver } from '../../../app/start_solver.ts';
import type { Scene } from '../../../scene/scene.ts';
import type { SolverClient } from '../../../solver/client.ts';
import { describeStatus } from '../../../solver/describe_status.ts';
import type { Frame } from '../../../solver/frame.ts';
import type { Parameters } from '../../../solver/module.ts';
import type { Command, Outcome, Pins, Request } from '../../../solver/protocol.ts';

export const trialNames = ['k', 'mass', 'delta_t', 'w', 'pins', 'positions', 'gravity', 'target'] as const;
export type TrialName = (typeof trialNames)[number];

/** What the solver is asked to simulate. */
export interface Settings {
  scene: Scene;
  parameters: Parameters;
  pins: Pins;
}

/** What the solver's counter showed before and after a change, and why it counted. */
export interface TrialResult {
  before: number;
  after: number;
  reason: Frame['factorisations']['reason'];
}

const moonGravity = 1.62; // m/s²
/** How far a pin is dragged, as a fraction of its distance from the origin, and m besides. */
const drag = { share: 0.05, least: 0.01 };

interface Change {
  parameters?: Partial<Parameters>;
  pins?: Pins;
  command?: Command;
}

/** All parameters go the way in which the solver never refuses: towards less stiffness in a time step. */
const changes: Record<TrialName, (settings: Settings) => Change> = {
  k: ({ parameters }) => ({ parameters: { k: parameters.k / 2 } }),
  mass: ({ parameters }) => ({ parameters: { mass_scale: parameters.mass_scale * 2 } }),
  delta_t: ({ parameters }) => ({ parameters: { delta_t: parameters.delta_t / 2 } }),
  w: ({ parameters }) => ({ parameters: { w: parameters.w / 10 } }),
  pins: ({ scene, pins }) => ({ pins: anotherSet(scene, pins) }),
  positions: () => ({ command: { kind: 'next_step' } }),
  gravity: () => ({ parameters: { gravity: moonGravity } }),
  target: ({ pins }) => ({ pins: { pinned: pins.pinned, targets: dragged(pins.targets) } }),
};

/** Makes changes to a simulation of its own, as often as asked, and says what that did to the factorisation. */
export class Trials {
  private readonly client: SolverClient = newSolver();

  /** From rest, with these settings; w can only be tried where pins are a penalty. Throws an Error in words, SolverCrash or Obstacle. */
  async run(name: TrialName, settings: Settings): Promise<TrialResult> {
    const parameters: Parameters =
      name === 'w' ? { ...settings.parameters, path: 'plain', method: 'local-global' } : settings.parameters;
    const start: Settings = { ...settings, parameters };
    const opened = taken(await this.client.open(settings.scene, request(start, {}), null));
    const changed = taken(await this.client.run(request(start, changes[name](start))));
    const { count, reason } = changed.frame.factorisations;
    return { before: opened.frame.factorisations.count, after: count, reason };
  }

  /** A simulation at work ends with it: its run() throws SolverCancelled. */
  dispose(): void {
    this.client.end();
  }
}

function request({ parameters, pins }: Settings, change: Change): Request {
  return {
    parameters: { ...parameters, ...change.parameters },
    pins: change.pins ?? pins,
    command: change.command ?? { kind: 'stay' },
    selectedVertex: null,
    wholeTrace: false,
    profile: false,
  };
}

function taken<T>(outcome: Outcome<T>): T {
  if (!outcome.ok) throw new Error(describeStatus(outcome.status));
  return outcome.value;
}

/** One pin fewer where there are several, else one more. */
function anotherSet({ V }: Scene, { pinned, targets }: Pins): Pins {
  if (pinned.length > 1) return { pinned: pinned.slice(0, -1), targets: targets.slice(0, -3) };
  const added = pinned[0] === 0 ? 1 : 0;
  return {
    pinned: Int32Array.of(...pinned, added),
    targets: Float64Array.of(...targets, ...V.subarray(3 * added, 3 * added + 3)),
  };
}

/** The first target, a little farther from the origin. */
function dragged(targets: Float64Array): Float64Array {
  return targets.map((x, at) => (at < 3 ? x * (1 + drag.share) + drag.least : x));
}
