import { inLanguage } from '../../../app/messages/in_language.ts';
import type { Sampling } from '../../../curves/sampling.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatLength, formatNumber } from '../../../lib/format.ts';
import { type Outline, svg } from '../outline.ts';
import { en } from './en.ts';
import type { Spread } from './spread.ts';
import { zh } from './zh.ts';

interface Props {
  sampling: Sampling;
  outline: Outline;
  spread: Spread;
  chosen: boolean;
  onChoose: () => void;
}

/** One way to spread the points: drawn, and in numbers. */
export function SpreadCard({ sampling, outline, spread, chosen, onChoose }: Props) {
  const words = inLanguage({ en, zh });
  const { sampled, largestGap, meanGap, error } = spread;
  const numbers = {
    gap: formatLength(largestGap),
    error: formatError(error),
    ratio: formatNumber(largestGap / meanGap, 2),
    count: sampled.t.length,
  };
  return (
    <div class="spread" data-chosen={chosen}>
      <label class="spread-name">
        <input type="radio" name="sampling" value={sampling} checked={chosen} onChange={onChoose} />
        {words.names[sampling]}
      </label>
      <svg viewBox={outline.viewBox.join(' ')} role="img" aria-label={fillTemplate(words.picture, numbers)}>
        <path class="spread-curve" d={outline.d} />
        <path class="spread-gap" d={spread.gapLine} />
        <path class="spread-points" d={dots(sampled.points)} />
      </svg>
      <dl>
        <div>
          <dt class="spread-gap-name">{words.gap}</dt>
          <dd>{numbers.gap}</dd>
        </div>
        <div>
          <dt>{words.error}</dt>
          <dd>{numbers.error}</dd>
        </div>
      </dl>
      <p>{fillTemplate(words.seen[sampling], numbers)}</p>
    </div>
  );
}

/** Below this the error is rounding. */
const smallestError = 1e-12; // m

function formatError(error: number): string {
  return error < smallestError ? '0' : formatLength(error);
}

/** Lines of no length with round ends: dots that stay as large however the picture is scaled. */
function dots(points: Float64Array): string {
  return Array.from({ length: points.length / 2 }, (_, i) => `M${svg(points, i)}h0`).join('');
}
