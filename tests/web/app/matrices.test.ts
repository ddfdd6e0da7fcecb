import { beforeEach, describe, expect, it } from 'vitest';
import {
  answered,
  askMatrices,
  eliminationRefusal,
  eliminationStep,
  eliminations,
  linearlyImplicit,
  linearSystem,
  type MatrixAnswer,
  matrices,
  matrixWishes,
  missingMatrices,
  noWishes,
  storageComparison,
} from '../../../web/src/app/matrices.ts';
import { route, springsRoute } from '../../../web/src/app/route.ts';
import { defaultState, frame, state } from '../../../web/src/app/state.ts';
import type { SolverClient } from '../../../web/src/solver/client.ts';
import type { Frame } from '../../../web/src/solver/frame.ts';
import type { EliminationStepRequest } from '../../../web/src/solver/matrices.ts';
import type { Ordering } from '../../../web/src/solver/module.ts';

const openRoom = () => {
  route.value = { page: 'springs', room: 'matrices' };
};
const setParameters = (parameters: (typeof state.value)['parameters']) => {
  state.value = { ...state.value, parameters };
};

/** Only what tells one answer from another. */
const client = {
  matrices: async () => ({}),
  elimination: async (ordering: Ordering) => ({ ordering }),
  eliminationStep: async ({ ordering, columns }: EliminationStepRequest) =>
    columns > 2 ? { ok: false, status: { code: 'index_out_of_range' } } : { ok: true, value: { ordering, columns } },
  compareStorage: async () => ({ n: 2 }),
  linearlyImplicit: async () => ({ K: 'K' }),
} as unknown as SolverClient;

/** Answers whatever is missing; what that was. */
async function answerAll(): Promise<string[]> {
  const asked: string[] = [];
  for (let question = missingMatrices.value; question; question = missingMatrices.value) {
    asked.push(question.kind === 'elimination' ? question.ordering : question.kind);
    answered(linearSystem.value, await askMatrices(client, question));
  }
  return asked;
}

beforeEach(() => {
  setParameters({ k: state.value.parameters.k === 1 ? 2 : 1 }); // whatever was answered before, this is another system
  state.value = { ...defaultState, parameters: state.value.parameters };
  matrixWishes.value = noWishes;
  openRoom();
});

describe('the matrix room', () => {
  it('asks for nothing while it is closed', () => {
    matrixWishes.value = { ...noWishes, orderings: ['natural'], storage: true };
    route.value = springsRoute;
    expect(missingMatrices.value).toBeNull();
    route.value = { page: 'springs', room: 'convergence' };
    expect(missingMatrices.value).toBeNull();
  });

  it('asks for the matrices once it is open, then for what is wished for, one after the other', async () => {
    expect(await answerAll()).toEqual(['matrices']);
    expect(matrices.value).not.toBeNull();
    matrixWishes.value = {
      orderings: ['solver', 'natural'],
      step: { ordering: 'natural', columns: 1 },
      storage: true,
      linearlyImplicit: true,
    };
    expect(await answerAll()).toEqual(['step', 'natural', 'solver', 'linearly-implicit', 'storage']);
    expect(eliminations.value).toEqual({ natural: { ordering: 'natural' }, solver: { ordering: 'solver' } });
    expect(storageComparison.value).toEqual({ n: 2 });
  });

  it('asks for every other step, and keeps the last one until it is answered', async () => {
    for (const columns of [1, 2, 1]) {
      matrixWishes.value = { ...noWishes, step: { ordering: 'natural', columns } };
      await answerAll();
      expect(eliminationStep.value?.columns).toBe(columns);
    }
    matrixWishes.value = { ...noWishes, step: { ordering: 'solver', columns: 1 } };
    expect(eliminationStep.value?.ordering).toBe('natural');
    expect(await answerAll()).toEqual(['step']);
  });

  it('says why there is no such step, and does not ask again', async () => {
    matrixWishes.value = { ...noWishes, step: { ordering: 'natural', columns: 3 } };
    await answerAll();
    expect(missingMatrices.value).toBeNull();
    expect(eliminationStep.value).toBeNull();
    expect(eliminationRefusal.value).toEqual({ code: 'index_out_of_range' });
  });

  it('begins anew for another Q, not where Q stays the same', async () => {
    await answerAll();
    setParameters({ ...state.value.parameters, iterations: 7, wind: true, method: 'lbfgs' });
    state.value = { ...state.value, pins: [] }; // no scene is open: there were none before
    expect(missingMatrices.value).toBeNull();
    setParameters({ ...state.value.parameters, k: 77 });
    expect(matrices.value).toBeNull();
    expect(await answerAll()).toEqual(['matrices']);
    state.value = { ...state.value, pins: [{ vertex: 0, target: [0, 0, 0] }] };
    expect(await answerAll()).toEqual(['matrices']);
    state.value = { ...state.value, pins: [{ vertex: 0, target: [0, 1, 0] }] };
    expect(missingMatrices.value).toBeNull();
  });

  it('asks for the matrices of linearly implicit Euler wherever the vertices have settled, and keeps the last ones until then', async () => {
    matrixWishes.value = { ...noWishes, linearlyImplicit: true };
    const at = (step: number, phase: Frame['phase']) => {
      frame.value = { step, phase } as Frame; // all that is read of it
    };
    at(3, 'predict');
    expect(await answerAll()).toEqual(['matrices', 'linearly-implicit']);
    at(3, 'global');
    at(2, 'accept'); // where time step 3 begins
    expect(missingMatrices.value).toBeNull();
    at(3, 'accept');
    expect(linearlyImplicit.value).toEqual({ K: 'K' });
    expect(await answerAll()).toEqual(['linearly-implicit']);
    setParameters({ ...state.value.parameters, wind: true });
    expect(missingMatrices.value).toBeNull(); // what is accepted stays where it is
    setParameters({ ...state.value.parameters, k: 79 });
    expect(linearlyImplicit.value).toBeNull();
    frame.value = null;
  });

  it('forgets what comes too late', async () => {
    const asked = linearSystem.value;
    const answer: MatrixAnswer = await askMatrices(client, { kind: 'matrices' });
    setParameters({ ...state.value.parameters, k: 78 });
    answered(asked, answer);
    expect(matrices.value).toBeNull();
  });
});
