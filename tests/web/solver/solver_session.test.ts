import { beforeEach, describe, expect, it } from 'vitest';
import { loadSolver } from '../../../web/headless/load_solver.ts';
import type { Command, Reply, Request } from '../../../web/src/solver/protocol.ts';
import { SolverSession } from '../../../web/src/solver/solver_session.ts';
import { net, usualParameters } from '../../support/small_scenes.ts';

const module = await loadSolver();
const { V, E, m, pinned } = net(3);
const targets = Float64Array.from([...pinned].flatMap((vertex) => [...V.subarray(3 * vertex, 3 * vertex + 3)]));
const parameters = { ...usualParameters, iterations: 4 };

function request(command: Command): Request {
  return { parameters, pins: { pinned, targets }, command, selectedVertex: null, wholeTrace: false, profile: false };
}

let session: SolverSession;

function run(command: Command): Reply {
  const outcome = session.run(request(command));
  if (!outcome.ok) throw new Error(outcome.status.code);
  return outcome.value;
}

beforeEach(() => {
  session = new SolverSession(module, () => {});
  session.open({ V, E, m }, request({ kind: 'stay' }), null);
});

const placeOf = ({ frame: { step, half_step, p } }: Reply) => ({ step, half_step, p });

describe('to another time step', () => {
  it('goes to its end, on and back, in the same bits', () => {
    const fourth = placeOf(run({ kind: 'go_to_step', step: 4 }));
    expect(fourth).toMatchObject({ step: 4, half_step: 9 });
    run({ kind: 'go_to_step', step: 12 });
    run({ kind: 'seek', half_step: 3 });
    expect(placeOf(run({ kind: 'go_to_step', step: 4 }))).toEqual(fourth);
    const one = new SolverSession(module, () => {});
    one.open({ V, E, m }, request({ kind: 'play', steps: 4 }), null);
    const outcome = one.run(request({ kind: 'stay' }));
    expect(outcome.ok && placeOf(outcome.value)).toEqual(fourth);
  });

  it('goes to the end of the present one', () => {
    run({ kind: 'go_to_step', step: 3 });
    run({ kind: 'seek', half_step: 2 });
    expect(placeOf(run({ kind: 'go_to_step', step: 3 }))).toMatchObject({ step: 3, half_step: 9 });
  });

  it('goes no farther back than is remembered', () => {
    const { frame } = run({ kind: 'go_to_step', step: 320 });
    expect(frame.rememberedSteps).toBe(300);
    expect(run({ kind: 'go_to_step', step: 5 }).frame).toMatchObject({ step: 20, rememberedSteps: 0 });
  });
});
