/** m: the part of the plane z = 0 that a picture shows. */
export interface Window {
  left: number;
  right: number;
  bottom: number;
  top: number;
}

/** The scenes whose springs all lie in the plane z = 0, with the part of it that they stay in when nobody pulls too hard. */
export const windows = {
  'single-spring-horizontal': { left: -1.5, right: 0.9, bottom: -1.45, top: 0.25 },
  triangle: { left: -1.1, right: 0.7, bottom: -1.15, top: 0.2 },
  square: { left: -0.7, right: 0.7, bottom: -1.05, top: 0.2 },
  'horizontal-chain': { left: -1.15, right: 1.15, bottom: -1.05, top: 0.25 },
  patch: { left: -0.75, right: 0.75, bottom: -1.25, top: 0.2 },
} as const satisfies Record<string, Window>;

export type PlanarScene = keyof typeof windows;
