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
  const set = (next: readonly MethodChoice[]) => actions.setIntegrators({ methods: next });
  return (
    <section class="method-list" aria-labelledby="methods-heading">
      <h3 id="methods-heading">{words.heading}</h3>
      <ol>
        {methods.map((choice, at) => (
          <MethodRow
            key={at}
            at={at}
            choice={choice}
            onSet={(next) => set(methods.map((other, index) => (index === at ? next : other)))}
            remove={
              methods.length > 1
                ? { name: names[at], onRemove: () => set(methods.filter((_, index) => index !== at)) }
                : null
            }
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
  choice: MethodChoice;
  onSet: (next: MethodChoice) => void;
  remove: { name: string; onRemove: () => void } | null;
}

function MethodRow({ at, choice, onSet, remove }: RowProps) {
  const { methods: words, short } = inLanguage({ en, zh });
  const entry = entryOf(choice);
  const count = countOf(entry);
  return (
    <li>
      <svg width="28" height="10" aria-hidden="true" class={`curve curve-${at}`}>
        <path d="M0 5H28" />
      </svg>
      <select
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
          {words[count]}
        </label>
      )}
      {remove && (
        <button
          type="button"
          class="quiet"
          aria-label={fillTemplate(words.remove, { name: remove.name })}
          title={fillTemplate(words.remove, { name: remove.name })}
          onClick={remove.onRemove}
        >
          <Icon name="close" />
        </button>
      )}
    </li>
  );
}
