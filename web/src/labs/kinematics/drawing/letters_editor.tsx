import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { CurveField } from './curve_field.tsx';
import { en } from './en.ts';
import type { LettersChoice } from './examples.ts';
import { ProblemNote } from './problem_note.tsx';
import { useDraft } from './use_draft.ts';
import { zh } from './zh.ts';

export function LettersEditor({ drawn, actions }: { drawn: LettersChoice; actions: Actions }) {
  const words = inLanguage({ en, zh }).letters;
  const { typed, problem, type } = useDraft(drawn, actions);
  return (
    <>
      <CurveField
        id="text"
        label={words.label}
        value={typed.text}
        problem={problem}
        hint="curve-hint"
        onType={(text) => type({ ...typed, text })}
      />
      <ProblemNote id="curve-problem" text={typed.text} problem={problem} />
      <p id="curve-hint" class="curve-hint">
        {words.hint}
      </p>
    </>
  );
}
