/** Of Δt·ω: from where on the explicit methods grow, as wasm/core/stability_limit.h says it. */
export interface StabilityLimits {
  symplectic: number;
  /** 0: without damping at any step size. */
  forward: number;
}

/** ω of the fastest oscillation, rad/s; of every spring damping, N·s/m, and stiffness k, N/m. */
export function stabilityLimits(omega: number, damping: number, k: number): StabilityLimits {
  const zeta = (damping * omega) / (2 * k);
  return {
    symplectic: 2 * (Math.sqrt(1 + zeta * zeta) - zeta),
    forward: zeta < 1 ? 2 * zeta : 2 * (zeta - Math.sqrt(zeta * zeta - 1)),
  };
}

/** The least number of substeps that stay below a limit. */
export function substepsBelow(limit: number, product: number): number {
  return Math.floor(product / limit) + 1;
}
