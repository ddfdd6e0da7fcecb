import type { Place } from './plane.ts';

const pitch = 12; // px a coil at rest
const radius = 5; // px
const straight = 8; // px at either end

/** An SVG path that looks like a spring: as many coils as its rest length has room for, drawn out or pushed together with it. */
export function springPath([x0, y0]: Place, [x1, y1]: Place, restLength: number): string {
  const length = Math.hypot(x1 - x0, y1 - y0);
  if (length < 2 * straight) return `M${round(x0)} ${round(y0)}L${round(x1)} ${round(y1)}`;
  const [ux, uy] = [(x1 - x0) / length, (y1 - y0) / length];
  const turns = Math.max(1, Math.round((restLength - 2 * straight) / pitch));
  const at = (along: number, aside: number) =>
    `L${round(x0 + along * ux - aside * uy)} ${round(y0 + along * uy + aside * ux)}`;
  const coils = Array.from({ length: 2 * turns }, (_, half) =>
    at(straight + ((length - 2 * straight) * (half + 0.5)) / (2 * turns), half % 2 === 0 ? radius : -radius),
  );
  return [`M${round(x0)} ${round(y0)}`, at(straight, 0), ...coils, at(length - straight, 0), at(length, 0)].join('');
}

/** A tenth of a pixel is as fine as anybody sees. */
function round(value: number): number {
  return Math.round(10 * value) / 10;
}
