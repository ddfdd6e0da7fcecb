import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { OrbitCamera } from '../../../../web/src/views/scene3d/orbit_camera.ts';
import { projectPoints, worldToClip } from '../../../../web/src/views/scene3d/projection.ts';

const view = { x: 0, y: 0, width: 600, height: 400 };

function onScreen(camera: OrbitCamera, points: Float64Array): [number, number][] {
  camera.setAspect(view.width / view.height);
  const screen = projectPoints(points, worldToClip(camera.camera), view);
  return Array.from({ length: points.length / 3 }, (_, v) => [screen[2 * v], screen[2 * v + 1]]);
}

describe('OrbitCamera', () => {
  const cloud = fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: 6, maxLength: 60 }).map((row) => {
    return Float64Array.from(row.slice(0, row.length - (row.length % 3)), (c) => c + 0.5);
  });

  it('fit shows every point', () => {
    fc.assert(
      fc.property(cloud, fc.double({ min: 0.7, max: 1.4, noNaN: true }), (points, polar) => {
        fc.pre(points.some((c, at) => Math.abs(c - points[at % 3]) > 0.05));
        const camera = new OrbitCamera();
        camera.fit({ points, polar, azimuth: 0.4 }, view.width / view.height);
        const places = onScreen(camera, points);
        const [xs, ys] = [places.map(([x]) => x), places.map(([, y]) => y)];
        expect(Math.min(...xs)).toBeGreaterThanOrEqual(0);
        expect(Math.max(...xs)).toBeLessThanOrEqual(view.width);
        expect(Math.min(...ys)).toBeGreaterThanOrEqual(0);
        expect(Math.max(...ys)).toBeLessThanOrEqual(view.height);
      }),
    );
  });

  it('a square facing the camera fills the height but for the margin', () => {
    const camera = new OrbitCamera();
    camera.fit(
      { points: Float64Array.of(-1, -1, 0, 1, 1, 0, 1, -1, 0, -1, 1, 0), polar: Math.PI / 2, azimuth: 0.4 },
      1.5,
    );
    const ys = onScreen(camera, Float64Array.of(0, -1, 0, 0, 1, 0)).map(([, y]) => y);
    // The margin is 18 %; perspective enlarges the corner nearest to the camera, which is turned aside, by less than 15 %.
    expect(ys[0] - ys[1]).toBeGreaterThan(view.height / 1.18 / 1.15);
    expect(ys[0] - ys[1]).toBeLessThan(view.height / 1.18);
  });

  it('its state comes back', () => {
    const camera = new OrbitCamera();
    camera.orbit(0.3, -0.2);
    camera.pan(10, 20, 400);
    const other = new OrbitCamera();
    other.state = camera.state;
    for (const key of ['position', 'target'] as const) {
      // Through angles and back: a few roundings of numbers near 1.
      for (let axis = 0; axis < 3; axis++) expect(other.state[key][axis]).toBeCloseTo(camera.state[key][axis], 12);
    }
  });

  it('orbiting keeps the distance and stops short of the poles', () => {
    const camera = new OrbitCamera();
    const { distance } = camera;
    camera.orbit(1, 100);
    expect(camera.distance).toBe(distance);
    expect(camera.state.position[0]).not.toBe(0);
    expect(camera.state.position[1]).toBeLessThan(0);
  });

  it('zooming in and out by the same factor comes back', () => {
    const camera = new OrbitCamera();
    const { distance } = camera;
    camera.zoom(1.5);
    expect(camera.distance).toBeCloseTo(distance / 1.5, 12);
    camera.zoom(1 / 1.5);
    expect(camera.distance).toBeCloseTo(distance, 12);
  });

  it('panning moves the target’s picture by as many pixels', () => {
    const camera = new OrbitCamera();
    const target = Float64Array.from(camera.state.target);
    const [[x, y]] = onScreen(camera, target);
    camera.pan(30, -40, view.height);
    const [[movedX, movedY]] = onScreen(camera, target);
    // Screen places are single precision, about 1e-5 of a pixel here.
    expect(movedX - x).toBeCloseTo(30, 3);
    expect(movedY - y).toBeCloseTo(-40, 3);
  });
});

it('a scene whose vertices all coincide is seen from a distance, too', () => {
  const camera = new OrbitCamera();
  const point = Float64Array.of(1, 2, 3, 1, 2, 3);
  camera.setScene(point);
  camera.fit({ points: point, polar: 1, azimuth: 0 }, 1.5);
  for (const [x, y] of onScreen(camera, point)) {
    expect(x).toBeCloseTo(view.width / 2, 3);
    expect(y).toBeCloseTo(view.height / 2, 3);
  }
});
