import { signal } from '@preact/signals';
import { beforeEach, describe, expect, it } from 'vitest';
import { type KinematicsSettings, kinematicsLimits } from '../../../../web/src/app/kinematics.ts';
import { notices } from '../../../../web/src/app/notices.ts';
import { defaultState, state } from '../../../../web/src/app/state.ts';
import { extended, FloorPen, type Stroke } from '../../../../web/src/views/scene3d/floor_pen.ts';

const actions = {
  setKinematics(change: Partial<KinematicsSettings>) {
    state.value = { ...state.value, kinematics: { ...state.value.kinematics, ...change } };
  },
};
/** The effector is at (0.1, 0.2, 0.3). */
const pose = signal({ x: Float64Array.of(0, 1, 0, 0.1, 0.2, 0.3), q: new Float64Array() });
const line: Stroke = [
  [0, 0],
  [0.5, 0],
];

let pen: FloorPen;
beforeEach(() => {
  notices.value = [];
  state.value = defaultState;
  pen = new FloorPen(actions, pose);
});
const draw = (stroke: Stroke) => {
  for (const place of stroke) pen.draw(place);
  pen.lift();
};

describe('extended', () => {
  it('rounds to millimetres and leaves out what is nearer than a centimetre to the last point', () => {
    expect(extended([], [0.12345, -0.0004], [])).toEqual([[0.123, 0]]);
    expect(extended([[0, 0]], [0.009, 0], [])).toEqual([[0, 0]]);
    expect(extended([[0, 0]], [0.01, 0], [])).toEqual([
      [0, 0],
      [0.01, 0],
    ]);
  });

  it('leaves out what is too far away, and what is one too many beside all other strokes', () => {
    expect(extended(line, [1e6, 0], [])).toBe(line);
    const others = [Array.from({ length: kinematicsLimits.hand.points - 3 }, () => [0, 0] as const)];
    const full = extended(line, [1, 0], others);
    expect(full).toHaveLength(3);
    expect(extended(full, [2, 0], others)).toBe(full);
  });
});

describe('FloorPen', () => {
  it('makes way for itself when it is taken: the arm stays where it is', () => {
    pen.take(false);
    expect(pen.on.value).toBe(true);
    expect(state.value.kinematics).toMatchObject({ mode: 'aim', target: [0.1, 0.2, 0.3] });
  });

  it('adds stroke to stroke, until they are cleared', () => {
    pen.take(false);
    draw(line);
    expect(state.value.kinematics).toMatchObject({ mode: 'draw', curve: { kind: 'hand', strokes: [line] } });
    draw([...line].reverse());
    expect(state.value.kinematics.curve).toEqual({ kind: 'hand', strokes: [line, [...line].reverse()] });
    pen.clear();
    expect(state.value.kinematics.mode).toBe('aim');
    draw(line);
    expect(state.value.kinematics).toMatchObject({ mode: 'draw', curve: { kind: 'hand', strokes: [line] } });
  });

  it('goes on with what was drawn by hand before', () => {
    pen.take(false);
    draw(line);
    pen.putAway();
    expect(pen.on.value).toBe(false);
    pen.take(false);
    expect(state.value.kinematics.mode).toBe('draw');
    draw(line);
    expect(state.value.kinematics.curve).toEqual({ kind: 'hand', strokes: [line, line] });
  });

  it('makes no stroke of a mere point', () => {
    pen.take(false);
    draw([[0.2, 0.2]]);
    expect(state.value.kinematics.mode).toBe('aim');
    expect(pen.stroke.value).toEqual([]);
  });

  it('draws only while it is down, and what is down when it is put away is a stroke', () => {
    pen.take(false);
    pen.move([0.1, 0]);
    expect(pen.stroke.value).toEqual([]);
    pen.draw(pen.place.value);
    pen.move([0.2, 0]);
    expect(pen.stroke.value).toEqual([
      [0.1, 0],
      [0.2, 0],
    ]);
    pen.putAway();
    expect(state.value.kinematics.mode).toBe('draw');
  });

  it('says so when it has drawn as many strokes as a link carries', () => {
    pen.take(false);
    for (let i = 0; i < kinematicsLimits.hand.strokes; i++) draw(line);
    expect(notices.value).toEqual([]);
    draw(line);
    expect(notices.value).toMatchObject([{ key: 'page.errors.drawnAll', params: { strokes: 100 } }]);
    expect(state.value.kinematics.curve).toMatchObject({ strokes: { length: 100 } });
  });
});
