/** Δt·ω: the places of the slider, up to a little beyond the limit of symplectic Euler. */
export const products: readonly number[] = Array.from({ length: 44 }, (_, at) => (at + 1) / 20);

/** Of Δt·ω: symplectic Euler explodes from here on. */
export const stabilityLimit = 2;

/** Where the slider stands at first: Δt·ω = 0.2, some thirty time steps a period. */
export const firstPlace = products.indexOf(0.2);
