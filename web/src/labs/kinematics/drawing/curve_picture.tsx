import { useMemo } from 'preact/hooks';
import type { CurveChoice } from '../../../curves/curve_choice.ts';
import { curveFrom } from '../../../curves/curve_from.ts';
import { outlineOf } from '../outline.ts';

/** A little picture of a curve, beside its name. */
export function CurvePicture({ choice }: { choice: CurveChoice }) {
  const outline = useMemo(() => {
    const made = curveFrom(choice);
    return made.ok ? outlineOf(made.curve, 0.05, 200) : null;
  }, [choice]);
  if (!outline) return null;
  return (
    <svg class="curve-picture" viewBox={outline.viewBox.join(' ')} aria-hidden="true">
      <path d={outline.d} />
    </svg>
  );
}
