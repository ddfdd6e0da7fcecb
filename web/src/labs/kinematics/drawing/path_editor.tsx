import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { en } from './en.ts';
import type { PathChoice } from './examples.ts';
import { ProblemNote } from './problem_note.tsx';
import { useDraft } from './use_draft.ts';
import { zh } from './zh.ts';

export function PathEditor({ drawn, actions }: { drawn: PathChoice; actions: Actions }) {
  const words = inLanguage({ en, zh }).path;
  const { typed, problem, type } = useDraft(drawn, actions);
  return (
    <>
      <label class="curve-field">
        <span>{words.label}</span>
        <textarea
          id="curve-d"
          rows={4}
          value={typed.d}
          spellcheck={false}
          autocapitalize="off"
          aria-invalid={problem !== null}
          aria-describedby={problem ? 'curve-problem curve-hint' : 'curve-hint'}
          onInput={(event) => type({ ...typed, d: event.currentTarget.value })}
        />
      </label>
      <ProblemNote id="curve-problem" text={typed.d} problem={problem} />
      <p id="curve-hint" class="curve-hint">
        {words.hint}
      </p>
    </>
  );
}
