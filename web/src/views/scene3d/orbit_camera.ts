import { Box3, PerspectiveCamera, Spherical, Vector3 } from 'three';
import type { Camera } from '../../app/state.ts';
import type { Framing } from './framing.ts';

/** Degrees, vertically: a long lens, so that springs of one length look alike across the view. */
const fieldOfView = 32;
const poleMargin = 0.02;
/** Metres: for scenes in which all vertices coincide. */
const leastRadius = 1e-3;
/** Around what `fit` brings into view. */
const margin = 1.18;

/** A camera that looks at a target from a distance and an angle, +y up. */
export class OrbitCamera {
  readonly camera = new PerspectiveCamera(fieldOfView);
  private readonly target = new Vector3();
  /** phi: from +y down; theta: about y, 0 looks along −z. */
  private readonly offset = new Spherical(3, 1.3, 0.4);

  private radius = 1;

  constructor() {
    this.apply();
  }

  /** Metres: about half the size of the scene. */
  get sceneRadius(): number {
    return this.radius;
  }

  /** V: #V×3, metres. */
  setScene(V: Float64Array): void {
    const size = new Box3().setFromArray(V).getSize(new Vector3());
    this.radius = Math.max(leastRadius, size.length() / 2);
    this.apply();
  }

  get state(): Camera {
    return { position: this.camera.position.toArray(), target: this.target.toArray() };
  }

  set state({ position, target }: Camera) {
    this.target.fromArray(target);
    this.offset.setFromVector3(new Vector3().fromArray(position).sub(this.target));
    this.apply();
  }

  /** Metres from camera to target. */
  get distance(): number {
    return this.offset.radius;
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

  /** Goes to the front and a little aside, as near as all the points allow in a view of this aspect. */
  fit({ points, polar, azimuth }: Framing, aspect: number): void {
    this.offset.set(1, polar, azimuth);
    this.target.set(0, 0, 0);
    this.apply();
    const [right, up, back] = [0, 1, 2].map((c) => new Vector3().setFromMatrixColumn(this.camera.matrix, c));
    const vertical = Math.tan((fieldOfView * Math.PI) / 360);
    const upwards = span(points, up, back, vertical);
    const sideways = span(points, right, back, vertical * aspect);
    const reach = Math.max(leastRadius, margin * upwards.reach, (margin * sideways.reach) / aspect);
    this.offset.radius = reach / vertical;
    this.target.addScaledVector(right, sideways.centre).addScaledVector(up, upwards.centre);
    this.apply();
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

/**
 * A camera looking along −back with slope tan(half field of view) sees a point of height h along `axis` and depth z along `back`
 * when h + slope·z ≤ slope·distance + centre and −h + slope·z ≤ slope·distance − centre.
 * Returns the least slope·distance at which it sees every point, and its centre then; metres.
 */
function span(points: Float64Array, axis: Vector3, back: Vector3, slope: number): { reach: number; centre: number } {
  let above = Number.NEGATIVE_INFINITY;
  let below = Number.NEGATIVE_INFINITY;
  const point = new Vector3();
  for (let at = 0; at < points.length; at += 3) {
    point.fromArray(points, at);
    const height = point.dot(axis);
    const depth = slope * point.dot(back);
    above = Math.max(above, depth + height);
    below = Math.max(below, depth - height);
  }
  return { reach: (above + below) / 2, centre: (above - below) / 2 };
}
