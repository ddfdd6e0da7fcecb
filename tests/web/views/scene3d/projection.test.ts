import fc from 'fast-check';
import { Vector3 } from 'three';
import { expect, it } from 'vitest';
import { OrbitCamera } from '../../../../web/src/views/scene3d/orbit_camera.ts';
import { facingPlane, pointOnPlane, projectPoints, worldToClip } from '../../../../web/src/views/scene3d/projection.ts';

const view = { x: 50, y: 20, width: 600, height: 400 };

function cameraOf(azimuth: number): OrbitCamera {
  const orbit = new OrbitCamera();
  orbit.orbit(azimuth, 0);
  orbit.setAspect(view.width / view.height);
  return orbit;
}

it('the target appears in the middle of the view', () => {
  const { camera } = cameraOf(0.3);
  expect([...projectPoints(new Float64Array(3), worldToClip(camera), view)]).toEqual([350, 220]);
});

it('what is behind the camera appears nowhere', () => {
  const orbit = cameraOf(0);
  const behind = Float64Array.from(orbit.state.position, (c) => 2 * c);
  expect([...projectPoints(behind, worldToClip(orbit.camera), view)]).toEqual([Number.NaN, Number.NaN]);
});

it('a point is found again under its own place on the plane through it', () => {
  const coordinate = fc.double({ min: -0.5, max: 0.5, noNaN: true });
  fc.assert(
    fc.property(coordinate, coordinate, coordinate, fc.double({ min: -3, max: 3, noNaN: true }), (x, y, z, azimuth) => {
      const { camera } = cameraOf(azimuth);
      const [screenX, screenY] = projectPoints(Float64Array.of(x, y, z), worldToClip(camera), view);
      const plane = facingPlane(camera, new Vector3(x, y, z));
      const found = pointOnPlane(camera, view, screenX, screenY, plane);
      // Screen places are single precision: 5e-5 pixels, and a pixel is about 4 mm.
      expect(found?.distanceTo(new Vector3(x, y, z))).toBeLessThan(1e-6);
    }),
  );
});
