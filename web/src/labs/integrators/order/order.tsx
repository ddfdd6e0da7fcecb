import { useRef, useState } from 'preact/hooks';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { Choice } from '../../../lib/choice.tsx';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { type Case, cases } from '../../../solver/order_of_accuracy.ts';
import { Prose } from '../../../views/equations/prose.tsx';
import { en } from './en.ts';
import { ErrorFigure } from './error_figure.tsx';
import { OneSpringEnergy } from './one_spring_energy.tsx';
import { useExperiment } from './use_experiment.ts';
import { zh } from './zh.ts';
import './order.css';

/** One spring by all methods with shorter and shorter time steps: how fast their errors vanish, and what becomes of its energy. */
export function OrderOfAccuracy() {
  const words = inLanguage({ en, zh });
  const section = useRef<HTMLElement>(null);
  const { results, failure, again } = useExperiment(section);
  const [shown, show] = useState<Case>('line');
  return (
    <section ref={section} id="order" class="order" aria-labelledby="order-heading" data-measured={results !== null}>
      <h3 id="order-heading">{words.heading}</h3>
      <Prose text={words.intro} />
      {failure !== null && (
        <div role="alert">
          <p class="integrators-failure">{fillTemplate(words.failed, { reason: failure })}</p>
          <button type="button" onClick={again}>
            {words.again}
          </button>
        </div>
      )}
      <div class="order-figures">
        <section aria-labelledby="order-errors-heading">
          <h4 id="order-errors-heading">{words.errors.heading}</h4>
          <Choice
            label={words.cases.label}
            options={cases.map((name) => [name, words.cases[name]] as const)}
            chosen={shown}
            onChoose={show}
          />
          <Prose text={words.setting[shown]} />
          {results && <ErrorFigure methods={results.errors[shown]} />}
          {results && <Prose text={words.seen[shown]} />}
          {!results && failure === null && <p class="evidence-empty">{words.running}</p>}
        </section>
        <section aria-labelledby="order-energy-heading">
          <h4 id="order-energy-heading">{words.energy.heading}</h4>
          <Prose text={words.energy.text} />
          {results && <OneSpringEnergy energies={results.energies} />}
        </section>
      </div>
    </section>
  );
}
