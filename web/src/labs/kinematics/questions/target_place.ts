import type { Point3 } from '../../../app/kinematics.ts';

/** Where a target lies in the plane of the picture, seen from the root. */
export interface TargetPlace {
  /** m. */
  distance: number;
  /** Degrees, from straight down to the right. */
  direction: number;
}

const degree = Math.PI / 180; // rad

/** m: how far the second target lies from the first, both as far from the root. */
const step = 0.01;

/** m. */
export function pointOf({ distance, direction }: TargetPlace, [x, y, z]: Point3): Point3 {
  return [x + distance * Math.sin(direction * degree), y - distance * Math.cos(direction * degree), z];
}

/** The place a centimetre further around the root. */
export function placeBeside(place: TargetPlace): TargetPlace {
  return { ...place, direction: place.direction + angleBeside(place) };
}

/** Degrees: between both, seen from the root. */
export function angleBeside({ distance }: TargetPlace): number {
  return step / distance / degree;
}

/** The place of a point, m from the root to the right and up; in whole centimetres and degrees. */
export function placeOf(right: number, up: number): TargetPlace {
  return {
    distance: Math.max(0.05, Math.round(100 * Math.hypot(right, up)) / 100),
    direction: Math.round(Math.atan2(right, -up) / degree) + 0,
  };
}
