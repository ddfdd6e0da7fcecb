import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { comparison } from '../../../web/src/app/comparison.ts';
import { eliminationStep, matrices, matrixWishes, noWishes } from '../../../web/src/app/matrices.ts';
import { notices } from '../../../web/src/app/notices.ts';
import { route, springsRoute } from '../../../web/src/app/route.ts';
import { Session } from '../../../web/src/app/session.ts';
import {
  defaultState,
  dragging,
  frame,
  furthestStep,
  liveFrame,
  playing,
  scene as sceneSignal,
  state,
} from '../../../web/src/app/state.ts';
import { solving } from '../../../web/src/app/work.ts';
import type { Scene } from '../../../web/src/scene/scene.ts';
import { SolverCancelled, type SolverClient, SolverCrash } from '../../../web/src/solver/client.ts';
import type { Frame } from '../../../web/src/solver/frame.ts';
import type { EliminationStepRequest } from '../../../web/src/solver/matrices.ts';
import type { MethodRequest, MethodRun, Opened, Outcome, Request } from '../../../web/src/solver/protocol.ts';

const scene: Scene = {
  name: 'pair',
  V: Float64Array.of(0, 0, 0, 1, 0, 0),
  E: Int32Array.of(0, 1),
  F: new Uint32Array(0),
  texture: null,
  m: Float64Array.of(1, 1),
  pinned: Int32Array.of(0),
  k: 10,
  delta_t: 0.1,
  iterations: 1,
  w: 1e6,
  gravity: 9.8,
  damping: 0,
};

/** Lets everything that has been promised happen. */
const turn = () => new Promise((done) => setTimeout(done));

/** A client that answers when told to, so that what happens in between can be looked at. */
class FakeClient {
  readonly requests: Request[] = [];
  /** That the solver stands in when it answers. */
  step = 1;
  private readonly answers: { resolve: (outcome: Outcome<Opened>) => void; reject: (reason: Error) => void }[] = [];

  private readonly ask = (request: Request) => {
    this.requests.push(request);
    return new Promise<Outcome<Opened>>((resolve, reject) => this.answers.push({ resolve, reject }));
  };
  readonly open = (_: unknown, request: Request) => this.ask(request);
  readonly run = this.ask;

  /** Answers at once, once it may. */
  readonly compared: string[] = [];
  mayCompare = Promise.resolve();
  readonly compare = async ({ method }: MethodRequest): Promise<Outcome<MethodRun>> => {
    this.compared.push(method);
    await this.mayCompare;
    const zero = Float64Array.of(0);
    return {
      ok: true,
      value: { method, change: zero, gradient: zero, decrease: zero, converged: true, milliseconds: 1 },
    };
  };

  readonly asked: (string | number)[] = [];
  readonly matrices = async () => {
    this.asked.push('matrices');
    return {};
  };
  readonly eliminationStep = async (request: EliminationStepRequest) => {
    this.asked.push(request.columns);
    await this.mayCompare;
    return { ok: true, value: request };
  };

  async settle(how: 'ok' | 'refused' | 'crash'): Promise<void> {
    await turn();
    const answer = this.answers.shift();
    if (!answer) throw new Error('nothing was asked');
    if (how === 'crash') answer.reject(new SolverCrash('unreachable'));
    else if (how === 'refused')
      answer.resolve({ ok: false, status: { code: 'too_stiff', field: 'k', index: -1, value: 2e9, limit: 1e9 } });
    else {
      const shown = { ...paused, step: this.step };
      answer.resolve({ ok: true, value: { frame: shown, checkpoint: checkpoint(), r: Float64Array.of(1) } });
    }
    await turn();
  }

  readonly cancel = () => this.answers.shift()?.reject(new SolverCancelled());

  get unanswered(): number {
    return this.answers.length;
  }
}

/** Its trace is complete, so nothing more is asked for on its account. */
const paused = { events: new Array(4), last_half_step: 3, milliseconds: 1 } as unknown as Frame;

function checkpoint() {
  return { step: 1, half_step: 0, p_curr: scene.V, p_prev: scene.V };
}

let client: FakeClient;
let session: Session;

beforeEach(async () => {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  state.value = defaultState;
  playing.value = false;
  dragging.value = null;
  notices.value = [];
  frame.value = null;
  comparison.value = null;
  route.value = springsRoute;
  matrixWishes.value = noWishes;
  client = new FakeClient();
  session = new Session(client as unknown as SolverClient);
  const opening = session.open(scene, { ...defaultState, scene: 'pair' });
  await client.settle('ok');
  expect(await opening).toBe(true);
  session.start();
  await client.settle('ok');
  client.requests.length = 0;
});

afterEach(() => {
  client.mayCompare = new Promise(() => {}); // this session goes on listening to the signals; it is to stay silent
});

const setK = (k: number) => {
  state.value = { ...state.value, parameters: { k } };
};

describe('the session', () => {
  it('coalesces: a slider dragged while the solver works asks once more, with the last value', async () => {
    for (const k of [11, 12, 13, 14]) setK(k);
    await client.settle('ok');
    await client.settle('ok');
    expect(client.requests.map(({ parameters }) => parameters.k)).toEqual([11, 14]);
    expect(client.unanswered).toBe(0);
  });

  it('never has two requests in flight', async () => {
    session.order({ kind: 'next_half_step' });
    session.order({ kind: 'next_half_step' });
    setK(20);
    expect(client.unanswered).toBe(1);
    await client.settle('ok');
    expect(client.unanswered).toBe(1);
  });

  it('goes where a slider is left, not everywhere it was dragged through', async () => {
    for (let half_step = 1; half_step < 9; half_step++) session.order({ kind: 'seek', half_step });
    for (let step = 1; step < 9; step++) session.order({ kind: 'go_to_step', step });
    for (let request = 0; request < 3; request++) await client.settle('ok');
    expect(client.requests.map(({ command }) => command)).toEqual([
      { kind: 'seek', half_step: 1 }, // in flight while the others came
      { kind: 'seek', half_step: 8 },
      { kind: 'go_to_step', step: 8 },
    ]);
    expect(client.unanswered).toBe(0);
  });

  it('remembers how far time has come when one goes back, until a reset', async () => {
    for (const [command, step, furthest] of [
      [{ kind: 'next_step' }, 5, 5],
      [{ kind: 'go_to_step', step: 2 }, 2, 5],
      [{ kind: 'next_step' }, 3, 5],
      [{ kind: 'reset' }, 1, 1],
    ] as const) {
      client.step = step;
      session.order(command);
      await client.settle('ok');
      expect(furthestStep.value).toBe(furthest);
    }
  });

  it('resets instead of the moves that wait', async () => {
    for (let move = 0; move < 9; move++) session.order({ kind: 'next_step' });
    session.order({ kind: 'reset' });
    await client.settle('ok');
    await client.settle('ok');
    expect(client.requests.map(({ command }) => command.kind)).toEqual(['next_step', 'reset']);
    expect(client.unanswered).toBe(0);
  });

  it('puts the accepted value back when the solver refuses one, and says why', async () => {
    setK(20);
    await client.settle('ok');
    setK(1e7);
    await client.settle('refused');
    expect(state.value.parameters).toEqual({ k: 20 });
    expect(notices.value[0]).toMatchObject({
      kind: 'error',
      key: 'page.errors.too_stiff',
      params: { value: '2.00 × 10⁹', limit: '1.00 × 10⁹' },
    });
  });

  it('does not ask for ever when even the accepted values fail', async () => {
    session.order({ kind: 'next_step' });
    await client.settle('refused');
    expect(client.unanswered).toBe(0);
    expect(playing.value).toBe(false);
  });

  it('stops the clock and says so when the solver crashes, and goes on when asked again', async () => {
    playing.value = true;
    session.order({ kind: 'play', steps: 1 });
    await client.settle('crash');
    expect(playing.value).toBe(false);
    expect(notices.value[0]).toMatchObject({ key: 'page.errors.crash', params: { reason: 'unreachable' } });
    session.order({ kind: 'next_half_step' });
    expect(client.unanswered).toBe(1);
  });

  it('gives up when told to: what was accepted is back, and nobody speaks of a crash', async () => {
    setK(20);
    await client.settle('ok');
    setK(30);
    await turn();
    solving.value = { stage: 'factorising', fraction: 0.5, vertices: 2 };
    session.cancel();
    await turn();
    expect(solving.value).toBeNull();
    expect(state.value.parameters).toEqual({ k: 20 });
    expect(notices.value).toMatchObject([{ kind: 'info', key: 'page.notice.cancelled' }]);
  });

  it('keeps the scene before when opening one is given up', async () => {
    const before = state.value;
    const opening = session.open({ ...scene, name: 'large' }, { ...state.value, scene: 'large' });
    await turn();
    session.cancel();
    expect(await opening).toBe(false);
    expect(state.value).toEqual(before);
  });

  it('asks nothing when only the camera, the theme or the language changes', () => {
    state.value = { ...state.value, view: { ...state.value.view, camera: { position: [1, 2, 3], target: [0, 0, 0] } } };
    state.value = { ...state.value, theme: 'dark', language: 'zh' };
    expect(client.unanswered).toBe(0);
  });

  it('sends what the reader chose while a value was being refused', async () => {
    setK(1e7);
    await turn();
    setK(30);
    await client.settle('refused');
    expect(state.value.parameters).toEqual({ k: 30 });
    await client.settle('ok');
    expect(client.requests.at(-1)?.parameters.k).toBe(30);
  });

  it('shows nothing of a new scene before all of it is there', async () => {
    const opening = session.open({ ...scene, name: 'next' }, { ...state.value, scene: 'next' });
    await turn();
    expect([sceneSignal.value.name, state.value.scene]).toEqual(['pair', 'pair']);
    state.value = { ...state.value, theme: 'dark' };
    await client.settle('ok');
    await opening;
    expect([sceneSignal.value.name, state.value.scene]).toEqual(['next', 'next']);
  });

  it('keeps the scene before when the solver refuses a new one', async () => {
    const before = state.value;
    const opening = session.open({ ...scene, name: 'bad' }, { ...state.value, scene: 'bad' });
    await client.settle('refused');
    expect(await opening).toBe(false);
    expect(state.value).toEqual(before);
  });

  it('asks for the rest of the trace when paused with nothing else to do', async () => {
    frame.value = { ...paused, events: [] };
    setK(15);
    await client.settle('ok');
    expect(client.requests[0].wholeTrace).toBe(false);
    frame.value = { ...paused, events: [] };
    session.order({ kind: 'stay' });
    await client.settle('ok');
    expect(client.requests.at(-1)?.wholeTrace).toBe(true);
  });

  it('while playing shows every frame as a picture, but in words and numbers no more than five a second', async () => {
    const start = performance.now() + 1000; // ms
    let now = start;
    const clock = vi.spyOn(performance, 'now').mockImplementation(() => now);
    playing.value = true;
    const [pictures, words] = [vi.fn(), vi.fn()];
    const stops = [liveFrame.subscribe(pictures), frame.subscribe(words)];
    const told = () => [pictures.mock.calls.length - 1, words.mock.calls.length - 1]; // each was told the frame before
    for (; now < start + 1000; now += 20) {
      session.order({ kind: 'play', steps: 1 });
      await client.settle('ok');
    }
    expect(told()).toEqual([50, 5]);
    session.order({ kind: 'play', steps: 1 });
    await client.settle('ok');
    playing.value = false;
    expect(frame.value).toBe(liveFrame.value);
    for (const stop of stops) stop();
    await client.settle('ok'); // what pausing asked for
    clock.mockRestore();
  });

  it('measures what an iteration takes while idle, and while playing once a second', async () => {
    frame.value = { ...paused, events: [] };
    session.order({ kind: 'stay' });
    await client.settle('ok');
    playing.value = true;
    session.order({ kind: 'play', steps: 1 });
    await client.settle('ok');
    expect(client.requests.map(({ profile }) => profile)).toEqual([true, false]);
  });

  describe('with the comparison on the page', () => {
    const show = () => {
      state.value = { ...state.value, view: { ...state.value.view, plot: 'comparison' } };
    };
    const quick = ['lbfgs', 'local-global', 'chebyshev', 'anderson'];

    it('runs the methods one by one when idle', async () => {
      show();
      await turn();
      expect(client.compared).toEqual(quick);
      expect(comparison.value?.runs.map(({ method }) => method)).toEqual(quick);
    });

    it('lets what the reader does go first', async () => {
      let allow = () => {};
      client.mayCompare = new Promise((done) => {
        allow = done;
      });
      show();
      session.order({ kind: 'next_half_step' });
      allow();
      await turn();
      expect(client.compared).toEqual(['lbfgs']); // it was on its way
      expect(client.unanswered).toBe(1);
      await client.settle('ok');
      expect(client.compared).toEqual(quick);
    });

    it('waits while the clock runs or a pin is dragged', async () => {
      playing.value = true;
      show();
      await turn();
      expect(client.compared).toEqual([]);
      playing.value = false;
      dragging.value = 0;
      await client.settle('ok');
      expect(client.compared).toEqual([]);
    });
  });

  describe('with the matrix room open', () => {
    const open = () => {
      route.value = { page: 'springs', room: 'matrices' };
    };
    const wish = (columns: number) => {
      matrixWishes.value = { ...noWishes, step: { ordering: 'natural', columns } };
    };

    it('asks for the matrices and for the step that is wished for, and for no other when that has changed meanwhile', async () => {
      open();
      wish(1);
      wish(2);
      await turn();
      let allow = () => {};
      client.mayCompare = new Promise((done) => {
        allow = done;
      });
      wish(3);
      wish(4);
      wish(5);
      allow();
      await turn();
      expect(client.asked).toEqual(['matrices', 2, 3, 5]);
      expect(matrices.value).not.toBeNull();
      expect(eliminationStep.value?.columns).toBe(5);
    });

    it('asks for nothing that was given up, but for another wish again', async () => {
      open();
      wish(1);
      await turn();
      client.mayCompare = Promise.reject(new SolverCancelled());
      wish(2);
      await turn();
      client.mayCompare = Promise.resolve();
      await turn();
      expect(client.asked.slice(-2)).toEqual([1, 2]);
      wish(3);
      await turn();
      expect(client.asked.slice(-3)).toEqual([1, 2, 3]);
    });

    it('waits while the clock runs', async () => {
      playing.value = true;
      setK(30); // matrices of which nothing is known yet
      open();
      await turn();
      expect(client.asked).toEqual([]);
      playing.value = false;
      await client.settle('ok');
      expect(client.asked).toEqual(['matrices']);
    });
  });
});
