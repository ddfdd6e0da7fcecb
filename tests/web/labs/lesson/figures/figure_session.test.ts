import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { openedScenes } from '../../../../../web/src/app/scene_library.ts';
import { FigureSession, type FigureSettings } from '../../../../../web/src/labs/lesson/figures/figure_session.ts';
import type { Frame } from '../../../../../web/src/solver/frame.ts';
import { lessonSolver } from '../../../../support/lesson_solver.ts';
import { openScene } from '../../../../support/open_scene.ts';

const settings: FigureSettings = {
  scene: 'patch',
  parameters: { iterations: 2 },
  selection: { spring: 0, vertex: 4 },
  opening: [{ kind: 'play', steps: 3 }, { kind: 'next_half_step' }],
};

let figure: FigureSession;
let stop: () => void;
/** The display's refresh: what waits for it, and how to let one pass, 50 ms after the one before. */
let waiting: FrameRequestCallback | null;
let now: number;

const place = () => `${figure.frame.value?.step}.${figure.frame.value?.half_step}`;
/** Lets everything happen that has been promised. */
const settle = () => new Promise((done) => setTimeout(done, 5));

async function refresh(): Promise<void> {
  const callback = waiting;
  waiting = null;
  now += 50;
  callback?.(now);
  await settle();
}

beforeEach(async () => {
  waiting = null;
  now = 0;
  vi.stubGlobal('requestAnimationFrame', (callback: FrameRequestCallback) => {
    waiting = callback;
    return 1;
  });
  vi.stubGlobal('cancelAnimationFrame', () => {
    waiting = null;
  });
  openedScenes.value = [await openScene('patch')];
  figure = new FigureSession(lessonSolver(), settings);
  stop = figure.start();
});

afterEach(() => stop());

async function wake(): Promise<void> {
  figure.awake.value = true;
  await settle();
}

describe('a figure', () => {
  it('asks for nothing before it is on the screen', async () => {
    await settle();
    expect(figure.frame.value).toBeNull();
  });

  it('opens at its own moment and shows none before', async () => {
    const seen: string[] = [];
    figure.frame.subscribe((frame) => {
      if (frame) seen.push(`${frame.step}.${frame.half_step}`);
    });
    await wake();
    expect(new Set(seen)).toEqual(new Set(['4.0']));
  });

  it('walks through time steps and back, bit for bit, though the solver remembers nothing', async () => {
    await wake();
    const seen: Frame[] = [];
    for (let move = 0; move < 7; move++) {
      seen.push(figure.frame.value as Frame);
      figure.order({ kind: 'next_half_step' });
      await settle();
    }
    expect(place()).toBe('5.1');
    for (const frame of seen.reverse()) {
      figure.order({ kind: 'previous_half_step' });
      await settle();
      expect(figure.frame.value?.p).toEqual(frame.p);
    }
    expect(place()).toBe('4.0');
  });

  it('takes turns with another figure without either noticing', async () => {
    const shared = lessonSolver();
    const [one, other, alone] = [shared, shared, lessonSolver()].map((solver) => new FigureSession(solver, settings));
    other.chosen.value = { iterations: 2, k: 50 };
    const stops = [one, other, alone].map((each) => each.start());
    for (const each of [one, other, alone]) each.awake.value = true;
    await settle();
    for (let step = 0; step < 3; step++) {
      for (const each of [one, other, alone]) each.order({ kind: 'next_step' });
      await settle();
    }
    expect(one.frame.value?.p).toEqual(alone.frame.value?.p);
    expect(other.frame.value?.p).not.toEqual(alone.frame.value?.p);
    for (const end of stops) end();
  });

  it('resets to its own moment, parameters and pins', async () => {
    await wake();
    const { p } = figure.frame.value as Frame;
    figure.setParameter('k', 999);
    figure.movePin(0, [-0.2, 0.1, 0]);
    figure.order({ kind: 'next_step' });
    await settle();
    figure.reset();
    await settle();
    expect(place()).toBe('4.0');
    expect(figure.frame.value?.p).toEqual(p);
    expect(figure.parameters.value).toMatchObject({ k: 200, iterations: 2 });
  });

  it('plays in time with the display, and sleeps where it is when it leaves the screen', async () => {
    await wake();
    figure.playing.value = true;
    for (let picture = 0; picture < 5; picture++) await refresh();
    const { step } = figure.frame.value as Frame;
    expect(step).toBeGreaterThan(4);
    figure.awake.value = false;
    await refresh();
    expect(waiting).toBeNull();
    expect(figure.frame.value?.step).toBe(step);
    await wake();
    for (let picture = 0; picture < 3; picture++) await refresh();
    expect(figure.frame.value?.step).toBeGreaterThan(step);
  });

  it('runs as long as a vertex is held, which is a pin for that time', async () => {
    await wake();
    const { step } = figure.frame.value as Frame;
    figure.held.value = { vertex: 7, target: [0.3, -1, 0] };
    for (let picture = 0; picture < 3; picture++) await refresh();
    expect([...(figure.frame.value as Frame).pinned]).toEqual([0, 2, 7]);
    expect(figure.frame.value?.step).toBeGreaterThan(step);
    figure.letGo();
    await settle();
    expect([...(figure.frame.value as Frame).pinned]).toEqual([0, 2]);
    expect(waiting).toBeNull();
  });

  it('leaves a pin where it is let go', async () => {
    await wake();
    figure.held.value = { vertex: 2, target: [0.5, 0.1, 0] };
    await refresh();
    figure.letGo();
    await settle();
    expect(figure.pins.value).toContainEqual({ vertex: 2, target: [0.5, 0.1, 0] });
  });

  it('resets from the midst of moves that wait', async () => {
    await wake();
    for (let move = 0; move < 9; move++) figure.order({ kind: 'next_step' });
    figure.reset();
    await settle();
    expect(place()).toBe('4.0');
    for (let move = 0; move < 9; move++) figure.order({ kind: 'next_step' });
    figure.order({ kind: 'reset' });
    await settle();
    expect(place()).toBe('1.0');
  });

  it('is moving until the moment that was asked for is there', async () => {
    await wake();
    expect(figure.moving).toBe(false);
    figure.order({ kind: 'next_step' });
    expect(figure.moving).toBe(true);
    await settle();
    expect(figure.moving).toBe(false);
  });

  it('says why the solver refuses, with what was accepted before, and goes on when the reason is gone', async () => {
    await wake();
    figure.setParameter('k', 300);
    await settle();
    const { p } = figure.frame.value as Frame;
    figure.setParameter('k', 1e12);
    await settle();
    expect(figure.refusal.value).toMatchObject({
      key: 'page.errors.too_stiff',
      params: { limit: '1.00 × 10⁹' },
    });
    expect(figure.parameters.value.k).toBe(300);
    expect(figure.frame.value?.p).toEqual(p);
    figure.setParameter('k', 100);
    await settle();
    expect(figure.refusal.value).toBeNull();
  });

  it('tells the lab all that it needs to show the same', async () => {
    await wake();
    figure.setParameter('k', 120);
    await settle();
    const { state, from } = figure.forLab() ?? {};
    expect(state).toEqual({
      scene: 'patch',
      parameters: { iterations: 2, k: 120 },
      pins: null,
      selection: { spring: 0, vertex: 4 },
    });
    expect(from).toMatchObject({ step: 4, half_step: 0 });
  });
});
