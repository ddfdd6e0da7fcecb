import { explicitIntegrators } from '../../../../app/integrators.ts';
import { encodeLink } from '../../../../app/link.ts';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { integratorsRoute } from '../../../../app/route.ts';
import { state } from '../../../../app/state.ts';
import { Display } from '../../../../views/equations/display.tsx';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import type { FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { InSlices } from '../../in_slices.tsx';
import { Sources } from '../../sources.tsx';
import { en } from './en.ts';
import { ExplicitForces } from './explicit_forces.tsx';
import { LandscapeFigure } from './landscape_figure.tsx';
import { free } from './landscape_grid.ts';
import { Slips } from './slips.tsx';
import { TwoWells } from './two_wells.tsx';
import { zh } from './zh.ts';
import './optimisation.css';

/** A step long enough that spring and inertia are equally strong. */
const oneFree: FigureSettings = {
  scene: 'single-spring-horizontal',
  parameters: { delta_t: 0.2 },
  selection: { spring: null, vertex: free },
  // Not the second step: after one from rest the printed E with a minus before inertia happens to have no slope, either.
  opening: [{ kind: 'play', steps: 2 }, { kind: 'next_half_step' }],
};

const { raw } = String;

const equationOfMotion = raw`\begin{aligned} & \frac{\symm_i}{\symdeltaT^2}(\symp_i - 2\sympCurr_i + \sympPrev_i) \\ & \quad {} + \frac{\partial\sympotential}{\partial\symp_i} - \symfExt_i = 0 \end{aligned}`;

const objective = raw`\begin{aligned}\symobjective = {} & \textstyle\sum_{ij} \tfrac{1}{2}\symk\,(\lVert \symp_i - \symp_j \rVert - \symr_{ij})^2 \\ & {} + \tfrac{1}{2\symdeltaT^2} \textstyle\sum_i \symm_i \lVert \symp_i - 2\sympCurr_i + \sympPrev_i \rVert^2 \\ & {} - \textstyle\sum_i \symp_i^{\mathrm T} \symfExt_i\end{aligned}`;

export function Optimisation() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(oneFree);
  return (
    <InSlices>
      <Prose text={words.intro} />
      <Display tex={equationOfMotion} />
      <Prose text={words.terms.gradient} />
      <h3>{words.terms.title}</h3>
      <Prose text={words.terms.wishes} />
      <Display tex={objective} />
      <LandscapeFigure figure={figure} />
      <Prose text={words.landscape.seen} />
      <h3>{words.nonlinear.title}</h3>
      <Question ask={words.nonlinear.ask} hint={words.nonlinear.hint} answer={words.nonlinear.answer}>
        <TwoWells figure={figure} />
      </Question>
      <h3>{words.explicit.title}</h3>
      <Question ask={words.explicit.ask} hint={words.explicit.hint} answer={words.explicit.answer}>
        <ExplicitForces />
        <Prose text={words.explicit.seen} />
        <p>
          <a href={encodeLink(integratorsRoute, { ...state.value, integrators: explicitIntegrators })}>
            {words.explicit.lab}
          </a>
        </p>
      </Question>
      <h3>{words.slips.title}</h3>
      <Prose text={words.slips.intro} />
      <Slips figure={figure} />
      <Sources items={words.sources} />
    </InSlices>
  );
}
