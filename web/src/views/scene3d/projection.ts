import { type Camera, Matrix4, Plane, type Ray, Raycaster, Vector2, Vector3 } from 'three';
import type { Rectangle } from '../../lib/rectangle.ts';

/** Column-major world → clip space. */
export function worldToClip(camera: Camera): Matrix4 {
  return new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
}

/** Where points (#×3, metres) appear in a view, as #×2 CSS pixels of the canvas; NaN behind the camera, which is nearest to nothing. */
export function projectPoints(points: Float64Array | Float32Array, matrix: Matrix4, view: Rectangle): Float32Array {
  const m = matrix.elements;
  const screen = new Float32Array((points.length / 3) * 2);
  for (let from = 0, to = 0; from < points.length; from += 3, to += 2) {
    const x = points[from];
    const y = points[from + 1];
    const z = points[from + 2];
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    const visible = w > 0 ? 1 / w : Number.NaN;
    screen[to] = view.x + view.width * (0.5 + 0.5 * visible * (m[0] * x + m[4] * y + m[8] * z + m[12]));
    screen[to + 1] = view.y + view.height * (0.5 - 0.5 * visible * (m[1] * x + m[5] * y + m[9] * z + m[13]));
  }
  return screen;
}

/** The plane through `point` that faces the camera: a dragged pin stays in it. */
export function facingPlane(camera: Camera, point: Vector3): Plane {
  return new Plane().setFromNormalAndCoplanarPoint(camera.getWorldDirection(new Vector3()), point);
}

/** From the eye through a place of the canvas, CSS pixels. */
export function rayThrough(camera: Camera, view: Rectangle, x: number, y: number): Ray {
  const device = new Vector2((2 * (x - view.x)) / view.width - 1, 1 - (2 * (y - view.y)) / view.height);
  const raycaster = new Raycaster();
  raycaster.setFromCamera(device, camera);
  return raycaster.ray;
}

/** The point of the plane under a place of the canvas (CSS pixels), or null when the ray misses it. */
export function pointOnPlane(camera: Camera, view: Rectangle, x: number, y: number, plane: Plane): Vector3 | null {
  return rayThrough(camera, view, x, y).intersectPlane(plane, new Vector3());
}
