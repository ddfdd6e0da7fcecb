import { signal } from '@preact/signals';
import { useEffect, useId, useMemo } from 'preact/hooks';
import { t } from '../../../app/messages/index.ts';
import { Obstacle } from '../../../app/obstacle.ts';
import { frame, parameters, pins, scene } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { SolverCancelled } from '../../../solver/client.ts';
import type { Frame } from '../../../solver/frame.ts';
import { Prose } from '../../../views/equations/prose.tsx';
import { roomWords } from './room_words.ts';
import { type TrialName, type TrialResult, Trials, trialNames } from './trials.ts';

interface Entry {
  guess?: boolean;
  result?: TrialResult;
  /** Why it could not be tried; empty when it could. */
  failure?: string;
}

/** Kept while the page is open. */
const entries = signal<Partial<Record<TrialName, Entry>>>({});
/** What is being tried. */
const trying = signal<TrialName | null>(null);

function note(name: TrialName, part: Entry): void {
  entries.value = { ...entries.value, [name]: { ...entries.value[name], ...part } };
}

/** What forces a new factorisation: first guessed, then tried. */
export function Ledger() {
  const words = roomWords().ledger;
  const trials = useMemo(() => new Trials(), []);
  useEffect(() => () => trials.dispose(), [trials]);
  const { factorisations } = frame.value as Frame;
  const tried = trialNames.filter((name) => entries.value[name]?.result);

  const run = async (name: TrialName) => {
    if (trying.value) return;
    trying.value = name;
    try {
      const result = await trials.run(name, { scene: scene.value, parameters: parameters.value, pins: pins.value });
      note(name, { result, failure: '' });
    } catch (reason) {
      if (reason instanceof SolverCancelled) return; // the reader has left
      const text = reason instanceof Obstacle ? t(reason.key, reason.params) : (reason as Error).message;
      note(name, { failure: text });
    } finally {
      trying.value = null;
    }
  };

  return (
    <div class="ledger">
      <Prose text={words.text} />
      <table class="numbers">
        <thead>
          <tr>
            <th scope="col">{words.change}</th>
            <th scope="col">{words.guess}</th>
            <th scope="col">
              <span class="visually-hidden">{words.try}</span>
            </th>
            <th scope="col">{words.counter}</th>
            <th scope="col">{words.truth}</th>
          </tr>
        </thead>
        <tbody>
          {trialNames.map((name) => (
            <Row key={name} name={name} onTry={() => void run(name)} />
          ))}
        </tbody>
      </table>
      <p role="status" class="ledger-score">
        {tried.length > 0 && fillTemplate(words.score, { right: tried.filter(isRight).length, tried: tried.length })}
      </p>
      <p class="aside" data-testid="own-factorisations">
        {fillTemplate(words.mine, {
          count: factorisations.count,
          reason: t(`page.solver.reason.${factorisations.reason}`),
        })}
      </p>
    </div>
  );
}

function isRight(name: TrialName): boolean {
  const { guess, result } = entries.value[name] ?? {};
  return result !== undefined && guess === refactorised(result);
}

function refactorised({ before, after }: TrialResult): boolean {
  return after > before;
}

function Row({ name, onTry }: { name: TrialName; onTry: () => void }) {
  const words = roomWords().ledger;
  const group = useId();
  const { guess, result, failure } = entries.value[name] ?? {};
  const impossible = name === 'target' && pins.value.pinned.length === 0;
  return (
    <tr data-trial={name}>
      <th scope="row">{words.rows[name].change}</th>
      <td>
        <fieldset class="guess" disabled={result !== undefined}>
          <legend class="visually-hidden">{words.guess}</legend>
          {[true, false].map((answer) => (
            <label key={String(answer)}>
              <input
                type="radio"
                name={group}
                checked={guess === answer}
                onChange={() => note(name, { guess: answer })}
              />
              {answer ? words.yes : words.no}
            </label>
          ))}
        </fieldset>
      </td>
      <td>
        <button
          type="button"
          disabled={guess === undefined || impossible || trying.value !== null}
          title={guess === undefined ? words.first : undefined}
          aria-label={`${words.try}: ${words.rows[name].change}`}
          onClick={onTry}
        >
          {trying.value === name ? words.trying : words.try}
        </button>
      </td>
      <td data-testid="counter">{result && `${result.before} → ${result.after}`}</td>
      <td class="truth" data-right={result && isRight(name)}>
        {impossible && words.noPins}
        {failure && fillTemplate(words.failed, { reason: failure })}
        {result && (
          <>
            <strong>{refactorised(result) ? words.again : words.kept}.</strong> {words.rows[name].why}{' '}
            <span class="aside">{isRight(name) ? words.right : words.wrong}</span>
          </>
        )}
      </td>
    </tr>
  );
}
