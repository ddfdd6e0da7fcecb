import type { Actions } from '../../../app/actions.ts';
import { frame } from '../../../app/state.ts';
import type { Frame } from '../../../solver/frame.ts';
import { Formula } from '../../../views/equations/formula.tsx';
import { Phrase, Prose } from '../../../views/equations/prose.tsx';
import { SymbolLegend } from '../../../views/equations/symbol_legend.tsx';
import { Timeline } from '../../../views/transport/timeline.tsx';
import type { en } from './en.ts';

const { raw } = String;

const perStep = raw`\sympCurr,\; \sympPrev,\; \symy`;
const perLocal = raw`\symd,\; \symb`;
const perGlobal = raw`\symp`;
const perNeither = raw`\symQ`;

/** Time step and half-step as two lines, with what is new on each; what the last move made new is marked. */
export function Levels({ words, actions }: { words: typeof en.levels; actions: Actions }) {
  const f = frame.value as Frame;
  const made = (phase: Frame['phase']) => f.phase === phase;
  return (
    <section class="convergence-levels">
      <h3>{words.title}</h3>
      <Prose text={words.text} />
      <Timeline frame={f} actions={actions} large />
      <dl>
        <div data-made={made('predict')}>
          <dt>{words.step}</dt>
          <dd>
            <Formula tex={perStep} />
          </dd>
        </div>
        <div>
          <dt>{words.halfStep}</dt>
          <dd>
            <span class="local" data-made={made('local')}>
              {words.local} <Formula tex={perLocal} />
            </span>{' '}
            <span class="global" data-made={made('global')}>
              {words.global} <Formula tex={perGlobal} />
            </span>
          </dd>
        </div>
        <div>
          <dt>{words.neither}</dt>
          <dd>
            <Formula tex={perNeither} />{' '}
            <span class="unless">
              <Phrase text={words.unless} />
            </span>
          </dd>
        </div>
      </dl>
      <SymbolLegend formulas={[perStep, perLocal, perGlobal, perNeither]} />
    </section>
  );
}
