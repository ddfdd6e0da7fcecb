import { useEffect } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { comparedParametersOn } from '../../app/integrators.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { t } from '../../app/messages/index.ts';
import { state } from '../../app/state.ts';
import { Nets } from '../../views/scene3d/nets.tsx';
import { diagonal } from '../../views/scene3d/screen_axes.ts';
import { DistanceChart } from './distance_chart.tsx';
import { en } from './en.ts';
import { EnergyChart } from './energy_chart.tsx';
import { MethodCards } from './method_cards.tsx';
import { MethodList } from './method_list.tsx';
import { namesOf } from './names.ts';
import { NetNote } from './net_note.tsx';
import { OrderOfAccuracy } from './order/order.tsx';
import { ResultsTable } from './results_table.tsx';
import { SameInstant } from './same_instant.tsx';
import { Settings } from './settings.tsx';
import { Stability } from './stability.tsx';
import { useSession } from './use_session.ts';
import { zh } from './zh.ts';
import './integrators.css';

/** One to four ways to make a time step, side by side on one scene and one clock. */
export function IntegratorsLab({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh });
  const run = useSession(actions);
  const { value: scene } = run.scene;
  const { methods, parameters, poke } = state.value.integrators;
  const names = namesOf(methods);
  const opened = scene.m.length > 0;

  useEffect(() => {
    document.title = `${words.title} – ${t('page.title')}`;
  }, [words.title]);
  useEffect(
    () =>
      run.states.subscribe((states) => {
        if (states) document.body.dataset.ready = 'true';
      }),
    [run],
  );

  if (!opened) return <p class="obstacle">{words.opening}</p>;
  const inForce = comparedParametersOn(scene, parameters);
  return (
    <main class="integrators" data-methods={methods.length}>
      <header>
        <h2>{words.title}</h2>
        <p class="integrators-intro">{words.intro}</p>
      </header>
      <div class="integrators-stage">
        <div class="integrators-nets" id="transport" tabIndex={-1}>
          <Nets
            run={run}
            poke
            pokeRadius={poke.radius * diagonal(scene.V)}
            pokeStiffness={poke.stiffness ?? inForce.k}
            showSprings={scene.F.length === 0}
            captions={names.map((name, net) => ({ name, note: <NetNote run={run} net={net} name={name} /> }))}
          />
          <p class="integrators-hint">{words.hint}</p>
        </div>
        <div class="integrators-controls">
          <MethodList actions={actions} />
          <Stability omega={run.frequency.value} parameters={inForce} methods={methods} />
          <Settings scene={scene} actions={actions} />
        </div>
      </div>
      <div class="integrators-evidence">
        <EnergyChart run={run} names={names} />
        <DistanceChart run={run} names={names} />
      </div>
      <ResultsTable run={run} names={names} />
      <SameInstant run={run} names={names} />
      <OrderOfAccuracy />
      <MethodCards methods={methods} />
    </main>
  );
}
