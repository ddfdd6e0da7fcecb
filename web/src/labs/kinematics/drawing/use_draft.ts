import { useEffect, useState } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import type { CurveChoice } from '../../../curves/curve_choice.ts';
import { curveFrom } from '../../../curves/curve_from.ts';
import type { CurveProblem } from '../../../curves/curve_problem.ts';

interface Draft<Choice> {
  /** What stands in the fields. */
  typed: Choice;
  /** Why the arm does not draw that, but what it drew before. */
  problem: CurveProblem | null;
  type: (next: Choice) => void;
}

/** What the reader types is drawn as soon as it describes a curve; `drawn` is what does at present. */
export function useDraft<Choice extends CurveChoice>(drawn: Choice, actions: Actions): Draft<Choice> {
  const [draft, setDraft] = useState<{ typed: Choice; problem: CurveProblem } | null>(null);
  useEffect(() => setDraft(null), [drawn]); // something else was chosen
  return {
    typed: draft?.typed ?? drawn,
    problem: draft?.problem ?? null,
    type(next) {
      const made = curveFrom(next);
      setDraft(made.ok ? null : { typed: next, problem: made.problem });
      if (made.ok) actions.setKinematics({ mode: 'draw', curve: next });
    },
  };
}
