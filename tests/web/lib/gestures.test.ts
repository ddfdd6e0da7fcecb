import { beforeEach, describe, expect, it, vi } from 'vitest';
import { type GestureHandlers, Gestures } from '../../../web/src/lib/gestures.ts';
import { FakeCanvas } from '../views/scene3d/fake_canvas.ts';

let canvas: FakeCanvas;
let gestures: Gestures;
const handlers = {
  grab: vi.fn<GestureHandlers['grab']>(),
  drag: vi.fn<GestureHandlers['drag']>(),
  release: vi.fn<GestureHandlers['release']>(),
  tap: vi.fn<GestureHandlers['tap']>(),
  orbit: vi.fn<GestureHandlers['orbit']>(),
  pan: vi.fn<GestureHandlers['pan']>(),
  zoom: vi.fn<GestureHandlers['zoom']>(),
  hover: vi.fn<GestureHandlers['hover']>(),
};

/** There is one thing to hold, at (50, 50). */
beforeEach(() => {
  vi.resetAllMocks();
  handlers.grab.mockImplementation((x, y) => x === 50 && y === 50);
  canvas = new FakeCanvas();
  gestures = new Gestures(canvas.asCanvas(), handlers);
});

const touch = (pointerId: number) => ({ pointerId, pointerType: 'touch' });

describe('one pointer', () => {
  it('drags what it took hold of, and lets go', () => {
    canvas.send('pointerdown', 50, 50);
    canvas.send('pointermove', 60, 55);
    expect(handlers.drag).toHaveBeenLastCalledWith(60, 55);
    canvas.send('pointerup', 60, 55);
    expect(handlers.release).toHaveBeenCalledOnce();
    expect(handlers.orbit).not.toHaveBeenCalled();
    expect(handlers.tap).not.toHaveBeenCalled();
  });

  it('orbits elsewhere, by as much as it moves', () => {
    canvas.send('pointerdown', 10, 10);
    canvas.send('pointermove', 20, 10);
    canvas.send('pointermove', 25, 40);
    expect(handlers.orbit.mock.calls).toEqual([
      [10, 0],
      [5, 30],
    ]);
  });

  it('taps when it hardly moves, and then moves nothing', () => {
    canvas.send('pointerdown', 50, 50);
    canvas.send('pointermove', 51, 51);
    canvas.send('pointerup', 51, 51);
    expect(handlers.tap).toHaveBeenCalledExactlyOnceWith(50, 50, 'mouse', false);
    expect(handlers.drag).not.toHaveBeenCalled();
  });

  it('with shift takes hold of nothing, so that shift-click can mean something else', () => {
    canvas.send('pointerdown', 50, 50, { shiftKey: true });
    canvas.send('pointerup', 50, 50, { shiftKey: true });
    expect(handlers.grab).not.toHaveBeenCalled();
    expect(handlers.tap).toHaveBeenCalledExactlyOnceWith(50, 50, 'mouse', true);
  });

  it('pans with the right button, and never taps', () => {
    canvas.send('pointerdown', 50, 50, { button: 2, buttons: 2 });
    canvas.send('pointermove', 70, 50, { buttons: 2 });
    canvas.send('pointerup', 70, 50, { button: 2, buttons: 0 });
    expect(handlers.pan).toHaveBeenCalledExactlyOnceWith(20, 0);
    expect(handlers.tap).not.toHaveBeenCalled();
  });

  it('is captured, so that a drag may leave the canvas', () => {
    canvas.send('pointerdown', 50, 50, { pointerId: 7 });
    expect(canvas.captured).toEqual([7]);
  });

  it('lets go without a tap when the browser takes the pointer away', () => {
    canvas.send('pointerdown', 50, 50);
    canvas.send('pointercancel', 50, 50);
    expect(handlers.release).toHaveBeenCalledOnce();
    expect(handlers.tap).not.toHaveBeenCalled();
  });

  it('hovers while no button is pressed; a finger never does', () => {
    canvas.send('pointermove', 30, 40);
    expect(handlers.hover).toHaveBeenLastCalledWith({ x: 30, y: 40 });
    canvas.send('pointermove', 60, 60, touch(2));
    expect(handlers.hover).toHaveBeenCalledOnce();
    canvas.send('pointerleave', 30, 40);
    expect(handlers.hover).toHaveBeenLastCalledWith(null);
  });
});

describe('two fingers', () => {
  it('let go of what the first one held, and tap nothing', () => {
    canvas.send('pointerdown', 50, 50, touch(1));
    canvas.send('pointerdown', 150, 50, touch(2));
    expect(handlers.release).toHaveBeenCalledOnce();
    canvas.send('pointermove', 70, 70, touch(1));
    canvas.send('pointerup', 70, 70, touch(1));
    canvas.send('pointerup', 150, 50, touch(2));
    expect(handlers.drag).not.toHaveBeenCalled();
    expect(handlers.tap).not.toHaveBeenCalled();
  });

  it('zoom by how much farther apart they are, and move by half of each', () => {
    canvas.send('pointerdown', 100, 100, touch(1));
    canvas.send('pointerdown', 200, 100, touch(2));
    canvas.send('pointermove', 250, 100, touch(2));
    expect(handlers.zoom).toHaveBeenCalledExactlyOnceWith(1.5, 175, 100); // about the point midway
    expect(handlers.pan).toHaveBeenCalledExactlyOnceWith(25, 0);
  });

  it('leave the camera to the one that stays', () => {
    canvas.send('pointerdown', 100, 100, touch(1));
    canvas.send('pointerdown', 200, 100, touch(2));
    canvas.send('pointerup', 100, 100, touch(1));
    canvas.send('pointermove', 220, 100, touch(2));
    expect(handlers.orbit).toHaveBeenCalledExactlyOnceWith(20, 0);
  });
});

describe('the wheel', () => {
  const zooming = { ctrlKey: true };

  it('alone is left to the page, which scrolls', () => {
    const event = canvas.send('wheel', 0, 0, { deltaY: -100 });
    expect(event.defaultPrevented).toBe(false);
    expect(handlers.zoom).not.toHaveBeenCalled();
  });

  it('with ctrl zooms, and there and back again is nothing', () => {
    const event = canvas.send('wheel', 0, 0, { deltaY: -100, ...zooming });
    canvas.send('wheel', 0, 0, { deltaY: 100, ...zooming });
    const [[nearer], [farther]] = handlers.zoom.mock.calls;
    expect(nearer).toBeGreaterThan(1);
    expect(nearer * farther).toBeCloseTo(1, 12);
    expect(event.defaultPrevented).toBe(true);
  });

  it('that counts in lines zooms as one that counts in pixels', () => {
    canvas.send('wheel', 0, 0, { deltaY: 1, deltaMode: 1, ...zooming });
    canvas.send('wheel', 0, 0, { deltaY: 16, ...zooming });
    const [[lines], [pixels]] = handlers.zoom.mock.calls;
    expect(lines).toBe(pixels);
  });

  it('of a mouse, whose notches are large, zooms by no more than a pinch', () => {
    canvas.send('wheel', 0, 0, { deltaY: -120, ...zooming });
    canvas.send('wheel', 0, 0, { deltaY: -20, ...zooming });
    const [[notch], [pinch]] = handlers.zoom.mock.calls;
    expect(notch).toBe(pinch);
  });
});

it('hears nothing more once disposed', () => {
  gestures.dispose();
  canvas.send('pointerdown', 50, 50);
  expect(handlers.grab).not.toHaveBeenCalled();
});
