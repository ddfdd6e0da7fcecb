import type { AtPoint } from '../../gradient_check.tsx';

const { raw } = String;

export interface PrintedSlip {
  id: 'sign' | 'half' | 'previous' | 'delta_t' | 'external';
  /** TeX. */
  printed: string;
  right: string;
  /** J: E with the printed term in place of the right one. */
  printedEnergy: (at: AtPoint) => number;
}

const fraction = raw`\frac{\symp_i - 2\sympCurr_i + \sympPrev_i}{\symdeltaT^2}`;
const squares = raw`\sum_i \symm_i \lVert \symp_i - 2\sympCurr_i + \sympPrev_i \rVert^2`;
const inertia = raw`\syminertia = \frac{\symdeltaT^2}{2} \sum_i \symm_i \Bigl\lVert ${fraction} \Bigr\rVert^2`;

/** Slips of the course texts in E; that of the pin term stands in the section on pins. */
export const printedSlips: readonly PrintedSlip[] = [
  {
    id: 'sign',
    printed: raw`\symobjective = \sympotential - \syminertia + \symexternal`,
    right: raw`\symobjective = \sympotential + \syminertia + \symexternal`,
    printedEnergy: ({ potential, inertia, external, pin }) => potential - inertia + external + pin,
  },
  {
    id: 'half',
    printed: raw`\syminertia = \symdeltaT^2 \sum_i \symm_i \Bigl\lVert ${fraction} \Bigr\rVert^2`,
    right: inertia,
    printedEnergy: ({ potential, inertia, external, pin }) => potential + 2 * inertia + external + pin,
  },
  {
    id: 'previous',
    printed: raw`\syminertia = \frac{1}{2\symdeltaT^2} \sum_i \symm_i \lVert \symp_i - 2\sympCurr_i - \sympPrev_i \rVert^2`,
    right: raw`\syminertia = \frac{1}{2\symdeltaT^2} ${squares}`,
    printedEnergy: ({ objective, inertia, p, p_curr, p_prev, m, delta_t }) =>
      objective -
      inertia +
      p.reduce((sum, x, c) => sum + m[Math.floor(c / 3)] * (x - 2 * p_curr[c] - p_prev[c]) ** 2, 0) /
        (2 * delta_t ** 2),
  },
  {
    id: 'delta_t',
    printed: raw`\syminertia = \frac{1}{2\symdeltaT} ${squares}`,
    right: raw`\syminertia = \frac{1}{2\symdeltaT^2} ${squares}`,
    printedEnergy: ({ potential, inertia, external, pin, delta_t }) => potential + delta_t * inertia + external + pin,
  },
  {
    id: 'external',
    printed: raw`\symexternal = \sum_i \symp_i^{\mathrm T} \symfExt_i`,
    right: raw`\symexternal = -\sum_i \symp_i^{\mathrm T} \symfExt_i`,
    printedEnergy: ({ potential, inertia, external, pin }) => potential + inertia - external + pin,
  },
];
