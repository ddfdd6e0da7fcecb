import { thinned } from './displacements.ts';

/** What a view should hold, and from where. */
export interface Framing {
  /** #×3, metres. */
  points: Float64Array;
  /** Radians from +y down. */
  polar: number;
  /** Radians about y, from the front. */
  azimuth: number;
}

/** Radians from +y down: for what stands upright and for what lies flat. */
const uprightPolar = 1.35;
const flatPolar = 0.9;
/** Radians from the front, for what has any depth to be seen. */
const sidewaysAzimuth = 0.4;
/** Depth, as a share of the width, from which that is so. */
const seenDepth = 0.02;
/** How deep a flat net sags between its pins, in distances to the nearest one. */
const sagShare = 0.6;
/** How far what hangs swings on to the other side. */
const swingShare = 0.7;
/** How many vertices and pins are asked for the room: in large scenes so many are as good as all, and each vertex looks at each pin. */
const mostVertices = 4000;
const mostPins = 200;

/** Where vertices and pins are. */
export function framingOfNow(p: Float64Array, targets: Float64Array): Framing {
  return { points: joined(p, targets), ...directionTo(p) };
}

/**
 * The scene at rest (V #V×3, metres) and the room in which it will fall: what lies among its pins sags, and what lies aside of them all
 * comes to hang beneath them, no lower than its distance to each pin allows, and swings on to the other side.
 */
export function framingOfFall(V: Float64Array, pinned: Int32Array): Framing {
  const flat = flatness(V);
  const pins = rowsOf(
    V,
    thinned(rowsOf(V, pinned), mostPins).map((row) => pinned[row]),
  );
  const room: number[] = [];
  if (pinned.length > 0) {
    const [alongX, , alongZ] = ranges(pins);
    for (let v = 0; v < V.length; v += 3 * Math.ceil(V.length / (3 * mostVertices))) {
      const x = V[v];
      const y = V[v + 1];
      const z = V[v + 2];
      const asideX = x - clamp(x, alongX);
      const asideZ = z - clamp(z, alongZ);
      const { distance, lowest } = reach(x, y, z, pins);
      const hangs = distance > 0 ? Math.hypot(asideX, asideZ) / distance : 0;
      const sag = sagShare * flat * distance;
      room.push(x - hangs * asideX, y - Math.max(sag, hangs * (y - lowest)), z - hangs * asideZ);
      room.push(x - (1 + swingShare) * hangs * asideX, y, z - (1 + swingShare) * hangs * asideZ);
    }
  }
  return { points: joined(V, room), ...directionTo(V) };
}

/** Metres: to the nearest pin, and the lowest y at which no pin is farther than at rest. */
function reach(x: number, y: number, z: number, pins: Float64Array): { distance: number; lowest: number } {
  let distance = Number.POSITIVE_INFINITY;
  let lowest = Number.NEGATIVE_INFINITY;
  for (let pin = 0; pin < pins.length; pin += 3) {
    const apart = Math.sqrt((pins[pin] - x) ** 2 + (pins[pin + 1] - y) ** 2 + (pins[pin + 2] - z) ** 2); // hypot is slow
    distance = Math.min(distance, apart);
    lowest = Math.max(lowest, pins[pin + 1] - apart);
  }
  return { distance, lowest };
}

function rowsOf(V: Float64Array, rows: Int32Array): Float64Array {
  return Float64Array.from([...rows].flatMap((v) => [...V.subarray(3 * v, 3 * v + 3)]));
}

function joined(a: ArrayLike<number>, b: ArrayLike<number>): Float64Array {
  const both = new Float64Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}

/** What lies flat is looked at from above, but a chain, which is as narrow as it is flat, from the front. */
function directionTo(points: Float64Array): Pick<Framing, 'polar' | 'azimuth'> {
  const [width, , depth] = ranges(points).map(({ least, most }) => most - least);
  const breadth = Math.min(width, depth) / Math.max(width, depth, Number.MIN_VALUE);
  return {
    polar: uprightPolar + (flatPolar - uprightPolar) * flatness(points) * breadth,
    azimuth: depth > seenDepth * width ? sidewaysAzimuth : 0,
  };
}

/** 0: at least as high as wide … 1: flat on the ground. */
function flatness(points: Float64Array): number {
  const [width, height, depth] = ranges(points).map(({ least, most }) => most - least);
  return Math.max(0, 1 - height / Math.max(width, depth));
}

interface Range {
  least: number;
  most: number;
}

/** Of points (#×3): along x, y and z. */
function ranges(points: Float64Array): Range[] {
  return [0, 1, 2].map((axis) => {
    const range = { least: Number.POSITIVE_INFINITY, most: Number.NEGATIVE_INFINITY };
    for (let at = axis; at < points.length; at += 3) {
      range.least = Math.min(range.least, points[at]);
      range.most = Math.max(range.most, points[at]);
    }
    return range;
  });
}

function clamp(value: number, { least, most }: Range): number {
  return Math.max(least, Math.min(most, value));
}
