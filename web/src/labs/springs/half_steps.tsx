import type { Actions } from '../../app/actions.ts';
import { type MessageKey, t } from '../../app/messages/index.ts';
import { holds } from '../../app/pointing.ts';
import { frame, labFigure, playing, r, scene, state } from '../../app/state.ts';
import { Icon } from '../../lib/icon.tsx';
import type { Frame } from '../../solver/frame.ts';
import { Controls } from '../../views/controls/controls.tsx';
import { GlobalEquation } from '../../views/equations/global_equation.tsx';
import { LocalEquation } from '../../views/equations/local_equation.tsx';
import { SpringInspector, VertexInspector } from '../../views/inspector/inspector.tsx';
import { Plots } from '../../views/plots/plots.tsx';
import { SolverPanel } from '../../views/solver_panel/solver_panel.tsx';
import { Transport } from '../../views/transport/transport.tsx';
import { InCode } from './in_code.tsx';
import { LabPinHandle } from './lab_pin_handle.tsx';
import { GlobalLegend, LocalLegend } from './legends.tsx';
import { Stage } from './stage.tsx';
import { scene3D } from './stage_signals.ts';
import './half_steps.css';

const localFiles = ['local_step.cpp', 'edge_vectors.cpp'] as const;
const globalFiles = ['global_step.cpp', 'right_hand_side.cpp', 'inertial_right_hand_side.cpp'] as const;

/** The lab's main screen: the two half-steps side by side, each over its equation; below them the clock, then what can be changed. */
export function HalfSteps({ actions }: { actions: Actions }) {
  const f = frame.value as Frame;
  return (
    <main class="springs-lab" ref={holds(labFigure)}>
      <div class="stage" data-phase={playing.value ? 'playing' : f.phase}>
        <Stage actions={actions} label={t('page.stage.label')} />
        <section class="half half-local" aria-label={t('page.local.name')}>
          <Caption name="page.local.name" tagline="page.local.tagline" />
          <div class="inspector">
            <SpringInspector actions={actions} />
          </div>
          <div class="view" data-view="local" role="img" aria-label={t('page.local.view')} />
          <LocalLegend />
          <div class="panel">
            <LocalEquation frame={f} spring={selectedSpring()} />
            <InCode files={localFiles} />
          </div>
        </section>
        <section class="half half-global" aria-label={t('page.global.name')}>
          <Caption name="page.global.name" tagline="page.global.tagline" />
          <div class="inspector">
            <VertexInspector actions={actions} />
          </div>
          <div class="view" data-view="global" role="img" aria-label={t('page.global.view')} />
          <GlobalLegend phase={f.phase} />
          <div class="panel">
            <GlobalEquation frame={f} />
            <InCode files={globalFiles} />
          </div>
        </section>
        <LabPinHandle actions={actions} />
        <button
          type="button"
          class="fit"
          aria-label={t('page.stage.fit')}
          title={t('page.stage.fit')}
          onClick={() => scene3D.value?.fit()}
        >
          <Icon name="fit" />
        </button>
      </div>
      <Transport actions={actions} />
      <div class="below">
        <details class="fold" open={!state.value.view.projector}>
          <summary>{t('page.controls.heading')}</summary>
          <Controls actions={actions} />
        </details>
        <div class="evidence">
          <Plots frame={f} actions={actions} />
          <SolverPanel />
        </div>
      </div>
    </main>
  );
}

function Caption({ name, tagline }: { name: MessageKey; tagline: MessageKey }) {
  return (
    <h2 class="caption">
      {t(name)} <span>{t(tagline)}</span>
    </h2>
  );
}

function selectedSpring() {
  const { spring } = state.value.selection;
  if (spring === null) return null;
  const { E } = scene.value;
  return { index: spring, i: E[2 * spring], j: E[2 * spring + 1], r: r.value[spring] };
}
