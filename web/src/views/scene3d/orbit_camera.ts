import { Box3, PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { CameraState } from './types.ts';

/** Degrees, vertically: a long lens, so that springs of one length look alike across the view. */
const fieldOfView = 32;
const poleMargin = 0.02;

/** A camera that looks at a target from a distance and an angle, +y up. */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(fieldOfView);
  private readonly target = new Vector3();
  /** phi: from +y down; theta: about y, 0 looks along −z. */
  private readonly offset = new Spherical(3, 1.3, 0.4);
  /** Metres: the scene's bounding box, and half its diagonal. */
  private readonly box = new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1));
  private radius = Math.sqrt(3);

  constructor() {
    this.apply();
  }

  get state(): CameraState {
    return { position: this.camera.position.toArray(), target: this.target.toArray() };
  }

  set state({ position, target }: CameraState) {
    this.target.fromArray(target);
    this.offset.setFromVector3(new Vector3().fromArray(position).sub(this.target));
    this.apply();
  }

  /** Metres from camera to target. */
  get distance(): number {
    return this.offset.radius;
  }

  /** Metres: half the diagonal of the scene. */
  get sceneRadius(): number {
    return this.radius;
  }

  /** CSS pixels that a metre at the target takes in a view of this height. */
  pixelsPerMetre(viewHeight: number): number {
    return viewHeight / (2 * Math.tan((fieldOfView * Math.PI) / 360) * this.offset.radius);
  }

  /** Radians. */
  orbit(azimuth: number, polar: number): void {
    this.offset.theta += azimuth;
    this.offset.phi = Math.max(poleMargin, Math.min(Math.PI - poleMargin, this.offset.phi + polar));
    this.apply();
  }

  /** Brings the camera nearer by a factor over 1. */
  zoom(factor: number): void {
    this.offset.radius = Math.max(0.01 * this.radius, Math.min(20 * this.radius, this.offset.radius / factor));
    this.apply();
  }

  /** Moves the scene under the camera by CSS pixels of a view of this height. */
  pan(dx: number, dy: number, viewHeight: number): void {
    const metres = 1 / this.pixelsPerMetre(viewHeight);
    const right = new Vector3().setFromMatrixColumn(this.camera.matrix, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrix, 1);
    this.target.addScaledVector(right, -dx * metres).addScaledVector(up, dy * metres);
    this.apply();
  }

  /** Rest positions of the scene, #V×3: they bound how far the camera goes and what `fit` frames. */
  setScene(V: Float64Array): void {
    this.box.copy(boxWithRoomBelow(V));
    this.radius = this.box.getSize(new Vector3()).length() / 2;
    this.apply();
  }

  /** Goes back to the front, a little above and aside, as near as the whole scene allows in a view of this aspect. */
  fit(aspect: number): void {
    this.box.getCenter(this.target);
    this.offset.set(this.radius, 1.3, 0.4);
    this.apply();
    this.offset.radius = 1.08 * this.nearestDistance(aspect);
    this.apply();
  }

  /** Metres from the target at which every corner of the scene is inside the view. */
  private nearestDistance(aspect: number): number {
    const vertical = Math.tan((fieldOfView * Math.PI) / 360);
    const turned = this.camera.quaternion.clone().invert();
    let nearest = 0;
    for (let corner = 0; corner < 8; corner++) {
      const [x, y, z] = [0, 1, 2].map((c) => (corner & (1 << c) ? this.box.max : this.box.min).getComponent(c));
      const seen = new Vector3(x, y, z).sub(this.target).applyQuaternion(turned);
      nearest = Math.max(
        nearest,
        seen.z + Math.max(Math.abs(seen.x) / (vertical * aspect), Math.abs(seen.y) / vertical),
      );
    }
    return nearest;
  }

  private apply(): void {
    this.camera.position.setFromSpherical(this.offset).add(this.target);
    this.camera.lookAt(this.target);
    this.camera.near = Math.max(this.offset.radius - 4 * this.radius, 0.01 * this.offset.radius);
    this.camera.far = this.offset.radius + 8 * this.radius;
    this.camera.updateMatrixWorld();
  }

  /** To be called before drawing or projecting in a view of this aspect. */
  setAspect(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
  }
}

/** The bounding box of the points (#×3), with room below: nets sag and flags fall before they hang. */
export function boxWithRoomBelow(points: Float64Array): Box3 {
  const box = new Box3().setFromArray(points);
  const size = box.getSize(new Vector3());
  box.min.y -= 0.3 * Math.max(size.x, size.z);
  return box;
}
