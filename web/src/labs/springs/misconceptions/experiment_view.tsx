import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { t } from '../../../app/messages/index.ts';
import { librarySceneNames } from '../../../app/scene_library.ts';
import type { SideBySide } from '../../../app/side_by_side.ts';
import { scene as labScene } from '../../../app/state.ts';
import { Choice } from '../../../lib/choice.tsx';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { Nets } from '../../../views/scene3d/nets.tsx';
import type { Card } from './cards.ts';
import { Costs } from './costs.tsx';
import { Curves } from './curves.tsx';
import { en } from './en.ts';
import { largestScene, type Order, openExperiment } from './experiment.ts';
import { Failure } from './failure.tsx';
import type { Measure } from './measures.ts';
import { useMovingPins } from './use_moving_pins.ts';
import { zh } from './zh.ts';

interface Props {
  run: SideBySide;
  card: Card;
  /** Of the nets, from left to right. */
  order: Order;
  names: readonly [string, string];
  /** Shown from the beginning. */
  measure: Measure;
  movesPins: boolean;
  /** Whether which net makes the mistake is a secret, and with it the scene that shows it best. */
  secret?: boolean;
  /** Between the nets and the evidence. */
  children?: ComponentChildren;
}

/** Two nets on one clock, and what differs between them as curves and numbers. */
export function ExperimentView({ run, card, order, names, measure, movesPins, secret = false, children }: Props) {
  const words = inLanguage({ en, zh }).stage;
  const [source, setSource] = useState<'best' | 'lab'>('best');
  const [moving, setMoving] = useState(movesPins);
  const scene = labScene.value;
  const tooLarge = scene.m.length > largestScene;
  const own = source === 'lab' && !tooLarge ? scene : null;

  useEffect(() => setMoving(movesPins), [movesPins]);
  useEffect(() => {
    let wanted = true;
    void openExperiment(run, card, own, order, () => wanted);
    return () => {
      wanted = false;
      run.playing.value = false;
    };
  }, [run, card, order, own]);
  useMovingPins(run, moving);

  return (
    <div class="experiment" id="transport" tabIndex={-1}>
      <Nets run={run} captions={names.map((name, net) => ({ name, note: <Failure run={run} net={net} /> }))} />
      <div class="experiment-settings">
        <label>
          <input type="checkbox" checked={moving} onChange={(event) => setMoving(event.currentTarget.checked)} />
          {words.movePins}
        </label>
        {!secret && (
          <Choice
            label={words.scene}
            options={[
              ['best', fillTemplate(words.best, { scene: sceneName(card.scene) })],
              ['lab', fillTemplate(words.lab, { scene: sceneName(scene.name) })],
            ]}
            chosen={source}
            onChoose={setSource}
          />
        )}
      </div>
      {source === 'lab' && tooLarge && <p>{fillTemplate(words.tooLarge, { limit: largestScene })}</p>}
      {own && hides(card, own.name) && <p>{words.hides}</p>}
      {children}
      <div class="experiment-evidence">
        <Curves
          run={run}
          names={names}
          initial={measure}
          explodes={card.explodes ?? false}
          right={order.indexOf('right')}
        />
        <Costs run={run} names={names} telling={!secret} />
      </div>
    </div>
  );
}

/** Only of the library's scenes is it known. */
function hides({ scene, also }: Card, name: string): boolean {
  return librarySceneNames.some((known) => known === name) && name !== scene && !also.includes(name);
}

function sceneName(name: string): string {
  const known = librarySceneNames.find((one) => one === name);
  return known ? t(`page.scenes.${known}`) : name;
}
