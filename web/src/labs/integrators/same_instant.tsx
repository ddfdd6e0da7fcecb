import { useEffect, useRef } from 'preact/hooks';
import { inLanguage } from '../../app/messages/in_language.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatLength, formatQuantity } from '../../lib/format.ts';
import { Phrase, Prose } from '../../views/equations/prose.tsx';
import { en } from './en.ts';
import { LabelledSelect } from './labelled_select.tsx';
import { zh } from './zh.ts';

/** One time step by every method from the motion of one of them, beside the exact minimiser. */
export function SameInstant({ run, names }: { run: SideBySide; names: readonly string[] }) {
  const words = inLanguage({ en, zh }).instant;
  const { value: leaders } = run.moving;
  const { value: leader } = run.leader;
  const { value: instant } = run.instant;
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    if (instant) section.current?.scrollIntoView({ block: 'nearest' }); // the key is pressed far above
  }, [instant]);
  return (
    <section ref={section} id="same-instant" class="same-instant" aria-labelledby="same-instant-heading">
      <h3 id="same-instant-heading">{words.heading}</h3>
      <Prose text={words.text} />
      <p class="same-instant-choice">
        <LabelledSelect
          label={words.from}
          value={String(leader)}
          options={leaders.map((at) => [String(at), names[at]] as const)}
          onChange={(value) => {
            run.wantedLeader.value = Number(value);
          }}
        />
        <button type="button" disabled={leaders.length === 0} onClick={() => void run.sameInstant(leader)}>
          {words.go}
        </button>
      </p>
      <div aria-live="polite">
        {instant && (
          <table class="results">
            <caption>
              {fillTemplate(words.caption, {
                name: names[instant.leader],
                time: formatQuantity(instant.milliseconds, 'ms', 2),
              })}
            </caption>
            <thead>
              <tr>
                <th scope="col">{inLanguage({ en, zh }).table.method}</th>
                <th scope="col">
                  <Phrase text={words.distance} />
                </th>
                <th scope="col">
                  <Phrase text={words.objective} />
                </th>
                <th scope="col">{words.time}</th>
              </tr>
            </thead>
            <tbody>
              {instant.errors.map((error, at) => (
                <tr key={names[at]}>
                  <th scope="row">{names[at]}</th>
                  <td>{error ? formatLength(error.distance) : words.failed}</td>
                  {/* Below the minimum is rounding. */}
                  <td>{error ? formatQuantity(Math.max(0, error.objective), 'J') : ''}</td>
                  <td>{error ? formatQuantity(instant.states[at].milliseconds, 'ms', 2) : ''}</td>
                </tr>
              ))}
            </tbody>
          </table>
        )}
      </div>
    </section>
  );
}
