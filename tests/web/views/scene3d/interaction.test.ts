import { beforeEach, describe, expect, it, vi } from 'vitest';
import { Interaction } from '../../../../web/src/views/scene3d/interaction.ts';
import { OrbitCamera } from '../../../../web/src/views/scene3d/orbit_camera.ts';
import { Poking } from '../../../../web/src/views/scene3d/poking.ts';
import { projectPoints, worldToClip } from '../../../../web/src/views/scene3d/projection.ts';
import type { Scene3DCallbacks } from '../../../../web/src/views/scene3d/types.ts';
import type { DrawnView } from '../../../../web/src/views/scene3d/view_picker.ts';
import { FakeCanvas } from './fake_canvas.ts';

/** A chain 0–1–2 of two springs, the first vertex pinned, in a view that fills the canvas. */
const points = Float64Array.of(-0.4, 0, 0, 0, 0, 0, 0.4, 0, 0);
const rectangle = { x: 0, y: 0, width: 400, height: 300 };
const view: DrawnView = {
  rectangle,
  points,
  springEnds: () => Float32Array.of(-0.4, 0, 0, 0, 0, 0, 0, 0, 0, 0.4, 0, 0),
  frame: {
    pinned: Int32Array.of(0),
    targets: points.slice(0, 3),
  },
  springPixels: 60,
  poke: null,
};

let canvas: FakeCanvas;
let orbitCamera: OrbitCamera;
let interaction: Interaction;
const callbacks = {
  onInvalidate: vi.fn<Scene3DCallbacks['onInvalidate']>(),
  onHover: vi.fn<Scene3DCallbacks['onHover']>(),
  onSelect: vi.fn<Scene3DCallbacks['onSelect']>(),
  onPinToggle: vi.fn<Scene3DCallbacks['onPinToggle']>(),
  onDragStart: vi.fn<Scene3DCallbacks['onDragStart']>(),
  onDrag: vi.fn<Scene3DCallbacks['onDrag']>(),
  onDragEnd: vi.fn<Scene3DCallbacks['onDragEnd']>(),
  onCameraChange: vi.fn<Scene3DCallbacks['onCameraChange']>(),
  onMark: vi.fn<NonNullable<Scene3DCallbacks['onMark']>>(),
  onPull: vi.fn<NonNullable<Scene3DCallbacks['onPull']>>(),
  onLegend: vi.fn<Scene3DCallbacks['onLegend']>(),
  onContextLost: vi.fn<Scene3DCallbacks['onContextLost']>(),
};

beforeEach(() => {
  vi.resetAllMocks();
  canvas = new FakeCanvas();
  orbitCamera = new OrbitCamera();
  interaction = new Interaction(canvas.asCanvas(), orbitCamera, () => view, callbacks);
});

/** Where a point of space appears. */
function placeOf(x: number, y: number, z: number): [number, number] {
  orbitCamera.setAspect(rectangle.width / rectangle.height);
  const [screenX, screenY] = projectPoints(Float64Array.of(x, y, z), worldToClip(orbitCamera.camera), rectangle);
  return [screenX, screenY];
}

describe('pick', () => {
  it('finds a vertex, a spring, or nothing', () => {
    expect(interaction.pick(...placeOf(0, 0, 0), 'mouse')).toMatchObject({ kind: 'vertex', index: 1 });
    expect(interaction.pick(...placeOf(0.2, 0, 0), 'mouse')).toMatchObject({ kind: 'spring', index: 1 });
    expect(interaction.pick(...placeOf(0, 0.5, 0), 'mouse')).toBeNull();
  });

  it('finds pins from farther away than other vertices', () => {
    const beside = ([x, y]: [number, number]): [number, number] => [x, y + 11];
    expect(interaction.pick(...beside(placeOf(-0.4, 0, 0)), 'mouse')?.index).toBe(0);
    expect(interaction.pick(...beside(placeOf(0.4, 0, 0)), 'mouse')).toBeNull();
  });
});

describe('a drag', () => {
  it('begins when the pin moves, carries it by as much as the pointer, and ends', () => {
    const [x, y] = placeOf(-0.4, 0, 0);
    canvas.send('pointerdown', x + 5, y);
    expect(callbacks.onDragStart).not.toHaveBeenCalled();
    canvas.send('pointermove', x + 35, y + 20);
    expect(callbacks.onDragStart).toHaveBeenCalledExactlyOnceWith(0);
    const [vertex, target] = callbacks.onDrag.mock.calls[0];
    expect(vertex).toBe(0);
    // The pointer held the pin 5 pixels aside of its centre and still does. Screen places are single precision.
    const [targetX, targetY] = placeOf(target[0], target[1], target[2]);
    expect(targetX).toBeCloseTo(x + 30, 3);
    expect(targetY).toBeCloseTo(y + 20, 3);
    canvas.send('pointerup', x + 35, y + 20);
    expect(callbacks.onDragEnd).toHaveBeenCalledExactlyOnceWith(0);
    expect(callbacks.onCameraChange).not.toHaveBeenCalled();
  });

  it('never starts on a vertex that is not pinned: that orbits', () => {
    const [x, y] = placeOf(0.4, 0, 0);
    canvas.send('pointerdown', x, y);
    canvas.send('pointermove', x + 35, y);
    expect(callbacks.onDragStart).not.toHaveBeenCalled();
    expect(callbacks.onCameraChange).toHaveBeenCalledOnce();
  });
});

describe('a tap', () => {
  const tap = ([x, y]: [number, number], shiftKey = false) => {
    canvas.send('pointerdown', x, y, { shiftKey });
    canvas.send('pointerup', x, y, { shiftKey });
  };

  it('selects, pins included, and on nothing clears the selection', () => {
    tap(placeOf(-0.4, 0, 0));
    expect(callbacks.onSelect).toHaveBeenLastCalledWith(expect.objectContaining({ kind: 'vertex', index: 0 }));
    expect(callbacks.onDragEnd).not.toHaveBeenCalled();
    tap(placeOf(0, 0.5, 0));
    expect(callbacks.onSelect).toHaveBeenLastCalledWith(null);
  });

  it('with shift pins or unpins a vertex, and selects nothing', () => {
    tap(placeOf(0.4, 0, 0), true);
    tap(placeOf(0.2, 0, 0), true);
    expect(callbacks.onPinToggle).toHaveBeenCalledExactlyOnceWith(2);
    expect(callbacks.onSelect).not.toHaveBeenCalled();
  });
});

describe('hovering', () => {
  it('tells once of each thing the pointer rests on', () => {
    const [x, y] = placeOf(0, 0, 0);
    canvas.send('pointermove', x, y);
    canvas.send('pointermove', x + 1, y);
    expect(callbacks.onHover).toHaveBeenCalledExactlyOnceWith(expect.objectContaining({ kind: 'vertex', index: 1 }));
    canvas.send('pointermove', ...placeOf(0, 0.5, 0));
    expect(callbacks.onHover).toHaveBeenCalledTimes(2);
    expect(callbacks.onHover).toHaveBeenLastCalledWith(null);
  });
});

describe('where nets can be poked', () => {
  /** The same chain, whose vertex 2 alone lies within 0.3 m of itself. */
  const poking = new Poking({ V: points, E: Int32Array.of(0, 1, 1, 2), F: new Uint32Array() });
  const poked = { ...view, poke: { poking, radius: 0.3, stiffness: 1e3 } };
  const to = ([x, y]: [number, number]): [number, number] => [x + 30, y - 20];

  beforeEach(() => {
    interaction.dispose();
    interaction = new Interaction(canvas.asCanvas(), orbitCamera, () => poked, callbacks);
  });

  it('a drag marks what it holds, pulls it by as much as the pointer moves, and ends', () => {
    const [x, y] = placeOf(0.4, 0, 0);
    canvas.send('pointerdown', x, y);
    expect(callbacks.onMark).toHaveBeenLastCalledWith(Int32Array.of(2));
    expect(callbacks.onPull).not.toHaveBeenCalled();
    canvas.send('pointermove', ...to([x, y]));
    const pull = callbacks.onPull.mock.lastCall?.[0];
    expect(pull).toMatchObject({ vertices: Int32Array.of(2), stiffness: 1e3 });
    const [targetX, targetY, targetZ] = pull?.targets ?? [];
    // Screen places are single precision.
    const [pulledX, pulledY] = placeOf(targetX, targetY, targetZ);
    expect(pulledX).toBeCloseTo(x + 30, 3);
    expect(pulledY).toBeCloseTo(y - 20, 3);
    canvas.send('pointerup', ...to([x, y]));
    expect(callbacks.onPull).toHaveBeenLastCalledWith(null);
    expect(callbacks.onMark).toHaveBeenLastCalledWith(null);
    expect(callbacks.onCameraChange).not.toHaveBeenCalled();
  });

  it('pins come first, and empty space still turns the camera', () => {
    canvas.send('pointerdown', ...placeOf(-0.4, 0, 0));
    canvas.send('pointermove', ...to(placeOf(-0.4, 0, 0)));
    canvas.send('pointerup', ...to(placeOf(-0.4, 0, 0)));
    expect(callbacks.onDrag).toHaveBeenCalledOnce();
    canvas.send('pointerdown', ...placeOf(0, 0.5, 0));
    canvas.send('pointermove', ...to(placeOf(0, 0.5, 0)));
    expect(callbacks.onCameraChange).toHaveBeenCalledOnce();
    expect(callbacks.onPull).not.toHaveBeenCalled();
  });

  it('a second finger lets go and takes hold of nothing', () => {
    const [x, y] = placeOf(0.4, 0, 0);
    canvas.send('pointerdown', x, y, { pointerType: 'touch' });
    canvas.send('pointermove', ...to([x, y]), { pointerType: 'touch' });
    canvas.send('pointerdown', x - 100, y, { pointerType: 'touch', pointerId: 2 });
    expect(callbacks.onPull).toHaveBeenLastCalledWith(null);
    canvas.send('pointermove', x - 120, y, { pointerType: 'touch', pointerId: 2 });
    expect(callbacks.onPull).toHaveBeenCalledTimes(2);
    expect(callbacks.onCameraChange).toHaveBeenCalled();
  });

  it('a mouse that rests on a net shows what a press would take hold of', () => {
    canvas.send('pointermove', ...placeOf(0.4, 0, 0));
    expect(callbacks.onMark).toHaveBeenLastCalledWith(Int32Array.of(2));
    canvas.send('pointermove', ...placeOf(0, 0.5, 0));
    expect(callbacks.onMark).toHaveBeenLastCalledWith(null);
  });
});
