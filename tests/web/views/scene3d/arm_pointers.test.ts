import { beforeEach, describe, expect, it, vi } from 'vitest';
import type { ArmPicture } from '../../../../web/src/views/scene3d/arm_picture.ts';
import { type ArmPointerCallbacks, ArmPointers } from '../../../../web/src/views/scene3d/arm_pointers.ts';
import type { Arm3D } from '../../../../web/src/views/scene3d/arm3d.ts';
import { OrbitCamera } from '../../../../web/src/views/scene3d/orbit_camera.ts';
import { projectPoints, worldToClip } from '../../../../web/src/views/scene3d/projection.ts';
import { FakeCanvas } from './fake_canvas.ts';

/** An arm of one link, its target aside of it and above the floor, seen slantwise from above. */
const picture = {
  x: Float64Array.of(0, 1, 0, 0, 0.2, 0),
  root: [0, 1, 0],
  links: [{ length: 0.8, bend: null }],
  target: [0.4, 0.5, 0.1],
} as unknown as ArmPicture;
const view = { x: 0, y: 0, width: 400, height: 300 };

let canvas: FakeCanvas;
let camera: OrbitCamera;
const moveCamera = vi.fn();
const callbacks = {
  onTarget: vi.fn<ArmPointerCallbacks['onTarget']>(),
  onJoint: vi.fn<ArmPointerCallbacks['onJoint']>(),
  mayDraw: vi.fn<ArmPointerCallbacks['mayDraw']>(),
  onPen: vi.fn<ArmPointerCallbacks['onPen']>(),
  onPenUp: vi.fn<ArmPointerCallbacks['onPenUp']>(),
};

beforeEach(() => {
  vi.resetAllMocks();
  callbacks.mayDraw.mockReturnValue(false);
  canvas = new FakeCanvas();
  camera = new OrbitCamera();
  camera.state = { position: [1, 3, 4], target: [0, 0.4, 0] };
  camera.setAspect(view.width / view.height);
  const arm = { eye: () => ({ picture, camera: camera.camera, view }), moveCamera } as unknown as Arm3D;
  new ArmPointers(canvas.asCanvas(), arm, callbacks);
});

/** Where a point of space appears; in single precision, so that 3 decimals of a pixel hold. */
function placeOf(point: ArrayLike<number>): [number, number] {
  const [x, y] = projectPoints(Float64Array.from(point), worldToClip(camera.camera), view);
  return [x, y];
}

const drag = ([x, y]: [number, number], dx: number, dy: number, more: Partial<PointerEvent> = {}) => {
  canvas.send('pointerdown', x, y, more);
  canvas.send('pointermove', x + dx, y + dy, more);
  canvas.send('pointerup', x + dx, y + dy, more);
};

describe('a drag', () => {
  it('of the target goes by as much as the pointer, at the same distance from the reader’s plane', () => {
    const place = placeOf(picture.target);
    drag([place[0] + 3, place[1]], 30, -20);
    const target = callbacks.onTarget.mock.lastCall?.[0] ?? [];
    const [x, y] = placeOf(target);
    expect(x).toBeCloseTo(place[0] + 30, 3);
    expect(y).toBeCloseTo(place[1] - 20, 3);
    const depth = (point: readonly number[]) => [-1, -2.6, -4].reduce((sum, to, axis) => sum + to * point[axis], 0);
    expect(depth(target)).toBeCloseTo(depth(picture.target), 12);
    expect(moveCamera).not.toHaveBeenCalled();
  });

  it('of its shadow moves it level with the floor', () => {
    const foot = [picture.target[0], 0, picture.target[2]];
    const place = placeOf(foot);
    drag(place, 30, 10);
    const [x, y, z] = callbacks.onTarget.mock.lastCall?.[0] ?? [0, 0, 0];
    expect(y).toBe(picture.target[1]);
    const [footX, footY] = placeOf([x, 0, z]);
    expect(footX).toBeCloseTo(place[0] + 30, 3);
    expect(footY).toBeCloseTo(place[1] + 10, 3);
  });

  it('elsewhere moves the camera', () => {
    drag(placeOf([-0.6, 0, 0.3]), 30, 0);
    expect(moveCamera).toHaveBeenCalledOnce();
    expect(callbacks.onTarget).not.toHaveBeenCalled();
    expect(callbacks.onPen).not.toHaveBeenCalled();
  });

  it('draws on the floor while the pen is held, but not beside the floor, and not with Shift', () => {
    callbacks.mayDraw.mockReturnValue(true);
    const place = placeOf([-0.6, 0, 0.3]);
    drag(place, 30, 0);
    const [[from], [to]] = callbacks.onPen.mock.calls;
    expect(from[0]).toBeCloseTo(-0.6, 5); // 3 decimals of a pixel of about 4 mm
    expect(from[1]).toBeCloseTo(0, 12);
    expect(from[2]).toBeCloseTo(0.3, 5);
    expect(placeOf(to)[0]).toBeCloseTo(place[0] + 30, 3);
    expect(callbacks.onPenUp).toHaveBeenCalledOnce();
    expect(moveCamera).not.toHaveBeenCalled();
    drag(placeOf([0, 0, -3]), 30, 0);
    drag(place, 30, 0, { shiftKey: true });
    expect(callbacks.onPenUp).toHaveBeenCalledOnce();
    expect(moveCamera).toHaveBeenCalledTimes(2);
  });
});

describe('the pen', () => {
  it('draws where the target or its shadow stands too', () => {
    callbacks.mayDraw.mockReturnValue(true);
    for (const place of [picture.target, [picture.target[0], 0, picture.target[2]]]) drag(placeOf(place), 30, 0);
    expect(callbacks.onPenUp).toHaveBeenCalledTimes(2);
    expect(callbacks.onTarget).not.toHaveBeenCalled();
  });
});

describe('a mouse that rests', () => {
  it('on a joint points at it, but the target comes first', () => {
    canvas.send('pointermove', ...placeOf([0, 1, 0]));
    expect(callbacks.onJoint).toHaveBeenLastCalledWith(0);
    canvas.send('pointermove', ...placeOf(picture.target));
    expect(callbacks.onJoint).toHaveBeenLastCalledWith(null);
    expect(canvas.style.cursor).toBe('grab');
  });
});
