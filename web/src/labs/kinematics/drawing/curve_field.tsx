import type { ComponentChildren } from 'preact';
import type { CurveProblem, CurveField as FieldName } from '../../../curves/curve_problem.ts';

interface Props {
  id: FieldName;
  label: ComponentChildren;
  value: string;
  problem: CurveProblem | null;
  /** Of what describes it, besides its problem. */
  hint?: string;
  onType: (text: string) => void;
}

/** A line that is typed and read at once. The note about its problem stands elsewhere, with the id `curve-problem`. */
export function CurveField({ id, label, value, problem, hint, onType }: Props) {
  const invalid = problem?.field === id;
  return (
    <label class="curve-field">
      <span>{label}</span>
      <input
        id={`curve-${id}`}
        value={value}
        autocomplete="off"
        autocapitalize="off"
        spellcheck={false}
        aria-invalid={invalid}
        aria-describedby={[invalid && 'curve-problem', hint].filter(Boolean).join(' ') || undefined}
        onInput={(event) => onType(event.currentTarget.value)}
        onKeyDown={(event) => {
          if (event.key === 'Enter') event.currentTarget.blur(); // and the page's own keys work again
        }}
      />
    </label>
  );
}
