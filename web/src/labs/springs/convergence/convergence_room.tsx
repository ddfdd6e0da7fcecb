import { useEffect } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { t } from '../../../app/messages/index.ts';
import { holds } from '../../../app/pointing.ts';
import { labFigure } from '../../../app/state.ts';
import { MethodControl } from '../../../views/controls/method_control.tsx';
import { ParameterControl } from '../../../views/controls/parameter_control.tsx';
import { Prose } from '../../../views/equations/prose.tsx';
import { ComparisonChart } from '../../../views/plots/comparison_chart.tsx';
import { Transport } from '../../../views/transport/transport.tsx';
import { en } from './en.ts';
import { FewIterations } from './few_iterations.tsx';
import { GapClosed, WhyKappa } from './gap_closed.tsx';
import { Levels } from './levels.tsx';
import { zh } from './zh.ts';
import './convergence.css';

/** How far each method comes in one time step, where it stops and why no farther, and what a step leaves undone. */
export function ConvergenceRoom({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh });
  useEffect(() => {
    actions.pause(); // one time step is looked at
    document.body.dataset.ready = 'true';
  }, [actions]);
  return (
    <main class="room convergence-room" ref={holds(labFigure)}>
      <header>
        <h2>{t('page.rooms.convergence')}</h2>
        <Prose text={words.intro} />
      </header>
      <section class="convergence-choices" aria-labelledby="gap-closed">
        <h3 id="gap-closed">{words.closed.title}</h3>
        <GapClosed words={words.closed} actions={actions} />
        <div class="controls">
          <ParameterControl name="k" letter="k" symbol="k" unit="N/m" actions={actions} />
          <ParameterControl name="delta_t" letter="Δt" symbol="deltaT" unit="s" actions={actions} />
          <ParameterControl name="iterations" letter="K" symbol={null} unit="" actions={actions} />
          <MethodControl actions={actions} />
        </div>
        <WhyKappa words={words.closed.why} />
      </section>
      <figure class="objective">
        <figcaption>{t('plots.title.comparison')}</figcaption>
        <ComparisonChart actions={actions} />
      </figure>
      <Levels words={words.levels} actions={actions} />
      <FewIterations words={words.damped} />
      <Transport actions={actions} timeline={false} />
    </main>
  );
}
