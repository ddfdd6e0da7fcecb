import { useEffect, useMemo, useRef } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { findScene } from '../../../../app/scene_library.ts';
import { SideBySide } from '../../../../app/side_by_side.ts';
import { pinsOn } from '../../../../app/state.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatNumber, formatQuantity } from '../../../../lib/format.ts';
import type { Mistake } from '../../../../solver/mistaken_simulation.ts';
import { sceneParameters } from '../../../../solver/scene_parameters.ts';
import { Nets } from '../../../../views/scene3d/nets.tsx';
import { en } from './en.ts';
import { meanStretch } from './mean_stretch.ts';
import { zh } from './zh.ts';

interface Shown {
  scene: string;
  mistakes: readonly Mistake[];
  /** What a net has come to, in one line. */
  note: (run: SideBySide, net: number) => string;
}

/** Held by one pin: more of them would keep the springs between them long. */
const forgottenK: Shown = {
  scene: 'triangle',
  mistakes: ['none', 'k-forgotten'],
  note: ({ states, scene, r }, net) => {
    const p = states.peek()?.[net].p;
    return p
      ? fillTemplate(words().length, { percent: formatNumber(100 * meanStretch(p, scene.peek().E, r.peek())) })
      : '';
  },
};

const swappedTimes: Shown = {
  scene: 'net',
  mistakes: ['none', 'times-swapped'],
  note: (run, net) => {
    const failure = run.states.peek()?.[net].failure;
    if (failure) return fillTemplate(words().failed, { step: failure.step });
    const energy = run.energies.peek()[net]?.at(-1);
    return energy ? fillTemplate(words().kinetic, { energy: formatQuantity(energy.kinetic, 'J') }) : '';
  },
};

const slowly: Shown = {
  scene: 'tower',
  mistakes: ['none', 'stored-zeros', 'factorised-again'],
  note: (run, net) => {
    const state = run.states.peek()?.[net];
    if (!state || run.step.peek() === 0) return '';
    const { milliseconds, factorisations } = state;
    return fillTemplate(words().cost, { time: formatQuantity(milliseconds, 'ms', 2), count: factorisations });
  },
};

export const ForgottenK = () => <MistakenNets {...forgottenK} />;
export const SwappedTimes = () => <MistakenNets {...swappedTimes} />;
export const Slowly = () => <MistakenNets {...slowly} />;

/** Solvers with mistakes beside the right one, from rest, on one clock, which stops off the screen. */
function MistakenNets({ scene, mistakes, note }: Shown) {
  const host = useRef<HTMLDivElement>(null);
  const run = useMemo(() => new SideBySide(), []);
  const { names } = words();

  useEffect(() => {
    let wanted = true;
    const stop = run.follow();
    const open = async () => {
      const found = await findScene(scene);
      const parameters = { ...sceneParameters(found), path: 'plain' as const }; // as the solvers with mistakes compute
      const start = { scene: found, pins: pinsOn(found, null), from: null };
      if (wanted)
        await run.open(
          mistakes.map((mistake) => ({ parameters, substeps: 1, mistake })),
          start,
        );
    };
    void open();
    return () => {
      wanted = false;
      stop();
    };
  }, [run, scene, mistakes]);

  useEffect(() => {
    const observer = new IntersectionObserver(([{ isIntersecting }]) => {
      if (!isIntersecting) run.playing.value = false;
    });
    observer.observe(host.current as HTMLElement);
    return () => observer.disconnect();
  }, [run]);

  run.energies.value; // as often as a reader can follow, instead of with every picture
  return (
    <div ref={host} class="mistaken-nets">
      <Nets
        run={run}
        captions={mistakes.map((mistake, net) => ({
          name: names[mistake as keyof typeof names],
          note: note(run, net),
        }))}
      />
    </div>
  );
}

function words() {
  return inLanguage({ en, zh }).nets;
}
