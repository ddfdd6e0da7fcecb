/** m, in the plane that is drawn on; x to the right, y up. */
export type Point2 = readonly [x: number, y: number];
