import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatQuantity } from '../../../../lib/format.ts';
import type { FigureSession } from '../../figures/figure_session.ts';
import type { Seen } from '../../figures/use_inspection.ts';
import { springVectors } from './spring_vectors.ts';

interface Props {
  figure: FigureSession;
  seen: Seen | null;
  /** With places for {{sum}} and {{trace}}. */
  text: string;
}

/** The springs' energy for the d of the figure's present moment, as a sum and as a trace. */
export function BothSides({ figure, seen, text }: Props) {
  return <p class="both-sides">{seen?.frame.d && fillTemplate(text, bothSides(figure, seen, seen.frame.d))}</p>;
}

/** ½k Σ‖(p_i − p_j) − d_ij‖², and ½k tr((Ap − d)ᵀ(Ap − d)) by columns. */
function bothSides(figure: FigureSession, { frame }: Seen, d: Float64Array): { sum: string; trace: string } {
  const { k } = figure.parameters.value;
  const missed = springVectors(figure, frame.p).map((x, c) => x - d[c]);
  const rows = Array.from({ length: missed.length / 3 }, (_, e) => Math.hypot(...missed.subarray(3 * e, 3 * e + 3)));
  const sum = rows.reduce((total, length) => total + length ** 2, 0);
  const diagonal = [0, 1, 2].map((axis) => missed.reduce((total, x, c) => (c % 3 === axis ? total + x * x : total), 0));
  const trace = diagonal[0] + diagonal[1] + diagonal[2];
  return { sum: formatQuantity(0.5 * k * sum, 'J'), trace: formatQuantity(0.5 * k * trace, 'J') };
}
