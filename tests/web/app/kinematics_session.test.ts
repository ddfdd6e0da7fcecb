import { beforeEach, expect, onTestFinished, test, vi } from 'vitest';
import { defaultKinematics, type KinematicsSettings } from '../../../web/src/app/kinematics.ts';
import { KinematicsSession } from '../../../web/src/app/kinematics_session.ts';
import { notices } from '../../../web/src/app/notices.ts';
import { countEvents } from '../../../web/src/app/pose.ts';
import { defaultState, state } from '../../../web/src/app/state.ts';
import { kinematicsService } from '../../../web/src/solver/kinematics_service.ts';
import { solver } from '../../support/open_simulation.ts';
import { PortWorker } from '../../support/port_worker.ts';

function want(change: Partial<KinematicsSettings>): void {
  state.value = { ...state.value, kinematics: { ...state.value.kinematics, ...change } };
}

function newWorker(): Worker {
  const worker = new PortWorker(kinematicsService(async () => solver));
  onTestFinished(() => worker.terminate());
  return worker.asWorker();
}

function newSession({ still = true, createWorker = newWorker } = {}): KinematicsSession {
  return new KinematicsSession({ still, createWorker, wasmBinary: async () => new ArrayBuffer(0) });
}

/** m: where the end effector is in what is shown. */
function effector(session: KinematicsSession): number[] {
  return [...(session.pose.value?.x.slice(-3) ?? [])];
}

function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Up to the rounding of rotations that are normalised once more. */
function expectSame(actual: Float64Array | undefined, expected: Float64Array | undefined): void {
  expect(actual).toHaveLength(expected?.length ?? -1);
  actual?.forEach((value, c) => {
    expect(value).toBeCloseTo(expected?.[c] ?? Number.NaN, 12);
  });
}

beforeEach(() => {
  notices.value = [];
  state.value = { ...defaultState, kinematics: { ...defaultKinematics, mode: 'aim' } };
});

test('the arm reaches for the target, from where it is, event by event and back', async () => {
  const session = newSession();
  await session.pursue();
  expect(distance(effector(session), defaultKinematics.target)).toBeLessThan(1e-4);
  const first = session.search.value;
  want({ target: [-0.3, 0.2, 0.9] });
  await session.pursue();
  const second = session.search.value;
  expectSame(second?.answer.start_x, first?.answer.x);
  expect(distance(effector(session), [-0.3, 0.2, 0.9])).toBeLessThan(1e-4);
  session.seek(0);
  expectSame(session.pose.value?.x, first?.answer.x);
  session.seek(1e9);
  expect(session.event.value).toBe(countEvents(second?.answer as never));
  session.seek(-1);
  expect(session.event.value).toBe(0);
});

test('another method looks for the same target from the same pose', async () => {
  const session = newSession();
  await session.pursue();
  want({ target: [-0.3, 0.2, 0.9] });
  await session.pursue();
  const ccd = session.search.value;
  want({ method: 'fabrik' });
  await session.pursue();
  const fabrik = session.search.value;
  expect(fabrik?.answer.start_x).toEqual(ccd?.answer.start_x);
  expect(fabrik?.answer.iterations).toBeLessThan(ccd?.answer.iterations as number);
});

test('from the hanging arm the same target is looked for once more', async () => {
  const session = newSession();
  await session.pursue();
  want({ target: [-0.3, 0.2, 0.9] });
  await session.pursue();
  await session.hang();
  expect(session.event.value).toBe(0);
  expect([...(session.pose.value?.x ?? [])].map((x) => Math.round(x * 10) / 10)).toEqual(
    [0, 1.7, 0, 0, 0.9, 0, 0, 0.5, 0, 0, 0.3, 0, 0, -0.9, 0], // mathematics.md: the joints' heights
  );
});

test('what is refused is said, and taken back', async () => {
  const session = newSession();
  await session.pursue();
  const before = state.value.kinematics;
  want({ target: [0, 1.7, 0] });
  await session.pursue();
  expect(state.value.kinematics).toBe(before);
  expect(notices.value).toMatchObject([{ key: 'page.errors.on_root' }]);
});

// No joint turns by 10° between two of the targets, but all do from the hanging arm to the first, which is free to.
test.each([null, 10])(
  'the arm draws: every target is reached, and the search for each can be looked into, turn limit %s',
  async (turn) => {
    want({ mode: 'draw', points: 50, turn });
    const session = newSession();
    await session.pursue();
    const { drawing } = session;
    const { followed, targets, strokes } = drawing.value as NonNullable<typeof drawing.value>;
    expect([...strokes]).toEqual(Array(51).fill(0));
    expect(Math.max(...followed.errors)).toBeLessThan(1e-4);
    for (const place of [0, 1, 50]) {
      await session.goTo(place);
      expect(session.search.value?.answer.iterations).toBe(followed.iterations[place]);
      expect(session.pose.value?.x).toEqual(followed.x.slice(15 * place, 15 * place + 15));
      expect(distance(effector(session), targets.subarray(3 * place, 3 * place + 3))).toBeLessThan(1e-4);
    }
  },
);

test('other settings keep the place in the drawing, another curve begins, a target ends it', async () => {
  want({ mode: 'draw', points: 50 });
  const session = newSession();
  await session.pursue();
  await session.goTo(30);
  want({ method: 'fabrik' });
  await session.pursue();
  expect(session.place.value).toBe(30);
  want({ points: 20 });
  await session.pursue();
  expect(session.place.value).toBe(20); // and the way back to the first
  want({ curve: { kind: 'star' } });
  await session.pursue();
  expect(session.place.value).toBe(20); // all of it, since nothing is to move by itself
  want({ mode: 'aim' });
  await session.pursue();
  expect(session.drawing.value).toBeNull();
});

test('a target in the midst of a drawing is reached for from where the arm then is', async () => {
  want({ mode: 'draw', points: 50 });
  const session = newSession();
  await session.pursue();
  const drawn = session.drawing.value?.followed.x;
  session.play();
  session.place.value = 20;
  want({ mode: 'aim' });
  await session.pursue();
  expectSame(session.search.value?.answer.start_x, drawn?.slice(15 * 20, 15 * 21));
});

test('a target that is refused leaves the drawing as it is', async () => {
  want({ mode: 'draw', points: 50 });
  const session = newSession();
  await session.pursue();
  await session.goTo(30);
  const drawing = session.drawing.value;
  want({ mode: 'aim', target: [0, 1.7, 0] }); // the root
  await session.pursue();
  expect(state.value.kinematics.mode).toBe('draw');
  expect(drawing).not.toBeNull();
  expect(session.drawing.value).toBe(drawing);
  expect(session.place.value).toBe(30);
});

test('drawing ends at the last target, also where fewer targets bring it nearer', async () => {
  const frames: FrameRequestCallback[] = [];
  vi.stubGlobal('requestAnimationFrame', (frame: FrameRequestCallback) => frames.push(frame));
  vi.stubGlobal('cancelAnimationFrame', () => frames.splice(0));
  onTestFinished(() => void vi.unstubAllGlobals());
  want({ mode: 'draw', points: 50 });
  const session = newSession();
  const leave = session.follow();
  await session.pursue();
  await vi.waitUntil(() => session.drawing.value);
  await session.goTo(40);
  session.play();
  want({ points: 20 });
  await vi.waitUntil(() => session.drawing.value?.strokes.length === 21);
  frames.splice(0).forEach((frame) => {
    frame(performance.now());
  });
  expect(session.place.value).toBe(20);
  expect(session.playing.value).toBe(false);
  leave();
});

test('whoever leaves in the midst of a change leaves no worker and nothing that plays', async () => {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => {});
  onTestFinished(() => void vi.unstubAllGlobals());
  let workers = 0;
  const createWorker = () => {
    workers += 1;
    return newWorker();
  };
  want({ mode: 'draw', points: 50 });
  const session = newSession({ still: false, createWorker });
  const leave = session.follow();
  await vi.waitUntil(() => session.drawing.value); // and the last target is being looked into
  want({ method: 'fabrik' });
  const wanted = state.value.kinematics;
  leave();
  await new Promise((resolve) => setTimeout(resolve, 50)); // ms: many times what an answer takes
  expect(workers).toBe(1);
  expect(session.playing.value).toBe(false);
  expect(state.value.kinematics).toBe(wanted);
});

test('a curve that cannot be read gives way to the default, and a word about it', async () => {
  want({ mode: 'draw', curve: { kind: 'formula', x: 'cos(', y: 't', from: '0', to: '1' } });
  const session = newSession();
  await session.pursue();
  expect(state.value.kinematics).toBe(defaultKinematics);
  expect(notices.value).toMatchObject([{ key: 'page.errors.curve', params: { field: 'x' } }]);
  expect(session.drawing.value).not.toBeNull();
});
