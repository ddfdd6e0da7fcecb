import { useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { type MethodChoice, mostMethods } from '../../app/integrators.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { state } from '../../app/state.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { Icon } from '../../lib/icon.tsx';
import { en } from './en.ts';
import { choiceOf, countOf, countsOf, type Entry, entries, entryOf, nextChoice } from './entries.ts';
import { namesOf } from './names.ts';
import { zh } from './zh.ts';

/** Which methods run side by side, one to four of them. */
export function MethodList({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh }).methods;
  const { methods } = state.value.integrators;
  const names = namesOf(methods);
  const rows = useRef<HTMLOListElement>(null);
  const set = (next: readonly MethodChoice[]) => actions.setIntegrators({ methods: next });
  const remove = (at: number) => {
    set(methods.filter((_, index) => index !== at));
    // Its button goes: the keyboard stays in the list, with who is next, or the last.
    const selects = [...(rows.current?.querySelectorAll<HTMLSelectElement>('.method-choice') ?? [])];
    selects[Math.min(at, methods.length - 2)].focus();
  };
  return (
    <section class="method-list" aria-labelledby="methods-heading">
      <h3 id="methods-heading">{words.heading}</h3>
      <ol ref={rows}>
        {methods.map((choice, at) => (
          <MethodRow
            key={at}
            at={at}
            name={names[at]}
            choice={choice}
            onSet={(next) => set(methods.map((other, index) => (index === at ? next : other)))}
            onRemove={methods.length > 1 ? () => remove(at) : null}
          />
        ))}
      </ol>
      {methods.length < mostMethods && (
        <button type="button" onClick={() => set([...methods, nextChoice(methods)])}>
          {words.add}
        </button>
      )}
    </section>
  );
}

const atOnce = entries.filter((entry) => countOf(entry) === 'substeps');
const groups = [
  ['atOnce', atOnce],
  ['iterated', entries.filter((entry) => !atOnce.includes(entry))],
] as const;

interface RowProps {
  at: number;
  name: string;
  choice: MethodChoice;
  onSet: (next: MethodChoice) => void;
  /** Null: the last one stays. */
  onRemove: (() => void) | null;
}

function MethodRow({ at, name, choice, onSet, onRemove }: RowProps) {
  const { methods: words, short } = inLanguage({ en, zh });
  const entry = entryOf(choice);
  const count = countOf(entry);
  return (
    <li>
      <svg width="28" height="10" aria-hidden="true" class={`curve curve-${at}`}>
        <path d="M0 5H28" />
      </svg>
      <select
        class="method-choice"
        value={entry}
        aria-label={fillTemplate(words.method, { number: at + 1 })}
        onChange={(event) => onSet(choiceOf(event.currentTarget.value as Entry))}
      >
        {groups.map(([group, some]) => (
          <optgroup key={group} label={words[group]}>
            {some.map((one) => (
              <option key={one} value={one}>
                {short[one]}
              </option>
            ))}
          </optgroup>
        ))}
      </select>
      {count && (
        <label class="method-count" title={count === 'substeps' ? words.substepsHint : undefined}>
          <select
            value={choice[count]}
            aria-label={fillTemplate(words.countOf, { name: short[entry], count: words[count].many })}
            onChange={(event) => onSet({ ...choice, [count]: Number(event.currentTarget.value) })}
          >
            {[...new Set([...countsOf[count], choice[count]])]
              .sort((a, b) => a - b)
              .map((number) => (
                <option key={number} value={number}>
                  {number}
                </option>
              ))}
          </select>{' '}
          {choice[count] === 1 ? words[count].one : words[count].many}
        </label>
      )}
      {onRemove && (
        <button
          type="button"
          class="quiet"
          aria-label={fillTemplate(words.remove, { name })}
          title={fillTemplate(words.remove, { name })}
          onClick={onRemove}
        >
          <Icon name="close" />
        </button>
      )}
    </li>
  );
}
