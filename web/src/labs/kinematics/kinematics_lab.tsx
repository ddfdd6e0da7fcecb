import { useComputed } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { t } from '../../app/messages/index.ts';
import { Arm } from '../../views/scene3d/arm.tsx';
import { FloorPen } from '../../views/scene3d/floor_pen.ts';
import { DrawingControls } from './drawing/drawing_controls.tsx';
import { en } from './en.ts';
import { Equations } from './equations/equations.tsx';
import { ErrorChart } from './equations/error_chart.tsx';
import { Result } from './equations/result.tsx';
import { DrawingErrors } from './motion/drawing_errors.tsx';
import { DrawingTransport } from './motion/drawing_transport.tsx';
import { Questions } from './questions/questions.tsx';
import { EvenSampling } from './sampling/even_sampling.tsx';
import { MethodChoice } from './settings/method_choice.tsx';
import { Settings } from './settings/settings.tsx';
import { Trace } from './trace/trace.tsx';
import { useSession } from './use_session.ts';
import { zh } from './zh.ts';
import './kinematics.css';

/** An arm that reaches for a target or draws a curve, with the equations beside it. */
export function KinematicsLab({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh });
  const session = useSession(actions);
  const pen = useMemo(() => new FloorPen(actions, session.pose), [actions, session]);
  const { value: drawing } = session.drawing;
  const ready = useComputed(() => session.pose.value !== null).value; // and not with every pose anew

  useEffect(() => {
    document.title = `${words.title} – ${t('page.title')}`;
  }, [words.title]);
  useEffect(() => {
    if (ready) document.body.dataset.ready = 'true';
  }, [ready]);

  if (!ready) return <p class="obstacle">{words.opening}</p>;
  return (
    <main class="kinematics">
      <header>
        <h2>{words.title}</h2>
        <p class="kinematics-intro">{words.intro}</p>
      </header>
      <div class="kinematics-stage">
        <div class="kinematics-arm" id="transport" tabIndex={-1}>
          <Arm session={session} actions={actions} pen={pen} />
          <Result session={session} />
          {drawing && <DrawingTransport session={session} drawing={drawing} />}
          <Trace session={session} />
          <DrawingControls actions={actions} pen={pen} />
          <ErrorChart session={session} />
          {drawing && <DrawingErrors session={session} drawing={drawing} />}
        </div>
        <div class="kinematics-equations">
          <MethodChoice actions={actions} />
          <Equations session={session} />
          <Settings actions={actions} />
        </div>
      </div>
      <EvenSampling actions={actions} />
      <Questions drawn={drawing?.targets ?? null} />
    </main>
  );
}
