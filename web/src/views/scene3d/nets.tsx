import { useSignal, useSignalEffect } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { notify } from '../../app/notices.ts';
import { appliedTheme } from '../../app/preferences.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { followLayout } from './follow_layout.ts';
import { NetsTransport } from './nets_transport.tsx';
import { Nets3D } from './nets3d.ts';
import { darkPalette, lightPalette } from './palette.ts';
import { PinHandle } from './pin_handle.tsx';
import { PokeHandle } from './poke_handle.tsx';
import { PullForce, PullReport } from './pull_forces.tsx';
import type { CanvasCallbacks, ScreenPoint } from './types.ts';
import './nets.css';

export interface NetCaption {
  name: string;
  /** Beside the name: what this net has come to. */
  note?: ComponentChildren;
}

interface Props {
  run: SideBySide;
  /** One for each variant, in their order. */
  captions: readonly NetCaption[];
  /** Whether the reader can take hold of the nets themselves and pull. */
  poke?: boolean;
  /** Metres: how far around the pointer vertices are taken hold of; null: a share of the scene's size. */
  pokeRadius?: number | null;
  /** N/m: of the spring that pulls each vertex. */
  pokeStiffness?: number;
  /** Springs are drawn anyway when the scene has no surface. */
  showSprings?: boolean;
}

/** The nets of several variants, one camera and one drag for all, over the buttons of their common clock. */
export function Nets({
  run,
  captions,
  poke = false,
  pokeRadius = null,
  pokeStiffness = 1e5,
  showSprings = true,
}: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const nets3D = useSignal<Nets3D | null>(null);
  const origin = useSignal<ScreenPoint>({ x: 0, y: 0 });
  const pictures = useSignal(0);
  const count = captions.length;

  useEffect(() => {
    const element = canvas.current as HTMLCanvasElement;
    let drawing = 0;
    const draw = () => {
      drawing = 0;
      view.render();
      pictures.value++;
    };
    const view = new Nets3D(
      element,
      callbacks(run, () => {
        drawing ||= requestAnimationFrame(draw);
      }),
    );
    nets3D.value = view;
    const views = (element.parentElement as HTMLElement).querySelectorAll('.net-view');
    const stopFollowing = followLayout(element, [...views], (corner, rectangles) => {
      origin.value = corner;
      view.setViewports(rectangles);
    });
    return () => {
      stopFollowing();
      cancelAnimationFrame(drawing);
      nets3D.value = null;
      view.dispose();
      run.pull.value = null;
    };
  }, [run, count, nets3D, origin, pictures]);

  useSignalEffect(() => {
    const { V, E, F, texture } = run.scene.value;
    const r = run.r.value;
    run.pull.value = null;
    if (r.length > 0) nets3D.value?.setScene({ V, E, F, texture, r }, count);
  });
  useSignalEffect(() => {
    const { value: states } = run.states;
    if (states) nets3D.value?.setFrame({ nets: states.map(({ p }) => p), ...run.pins.value });
  });
  useSignalEffect(() => {
    nets3D.value?.setOptions({ palette: appliedTheme.value === 'dark' ? darkPalette : lightPalette });
  });

  useSignalEffect(() => {
    nets3D.value?.setOptions({ pull: run.pull.value });
  });
  const view = nets3D.value;
  useEffect(() => {
    view?.setOptions({ showSprings, poke: poke ? { radius: pokeRadius, stiffness: pokeStiffness } : null });
  }, [view, showSprings, poke, pokeRadius, pokeStiffness]);

  const placeOf = (vertex: number) => {
    const place = nets3D.value?.placeInView(vertex);
    const { x, y } = origin.value;
    return place ? { x: x + place.x, y: y + place.y } : null;
  };
  return (
    <div class="nets" data-step={run.step.value} data-pulled={run.pull.value?.vertices.length ?? 0}>
      <div class="nets-views" style={{ '--nets': count }}>
        <canvas
          key={count}
          ref={canvas}
          class="nets-canvas"
          aria-label={t(poke ? 'page.poke.label' : 'page.nets.label')}
          role="img"
        />
        {captions.map(({ name, note }, net) => (
          <section key={net} class="net">
            <h4>{name}</h4>
            <div class="net-view">{view && poke && <PullForce nets={view} net={net} pictures={pictures} />}</div>
            <p class="net-note">{note}</p>
          </section>
        ))}
        {view && run.states.value && (
          <PinHandle
            pins={run.pins.value}
            V={run.scene.value.V}
            camera={() => view.camera}
            placeOf={placeOf}
            pictures={pictures}
            onMove={(vertex, target) => run.movePin(vertex, target)}
          />
        )}
        {view && poke && run.states.value && (
          <>
            <PokeHandle
              nets={view}
              V={run.scene.value.V}
              stiffness={pokeStiffness}
              pull={run.pull.value}
              placeOf={placeOf}
              pictures={pictures}
              onPull={(pull) => {
                run.pull.value = pull;
              }}
            />
            <PullReport nets={view} pull={run.pull.value} />
          </>
        )}
      </div>
      <NetsTransport run={run} onFit={() => view?.fit()} />
    </div>
  );
}

function callbacks(run: SideBySide, onInvalidate: () => void): CanvasCallbacks {
  return {
    onInvalidate,
    onHover: () => {},
    onSelect: () => {},
    onPinToggle: () => {},
    onDragStart: (vertex) => {
      run.held.value = vertex;
    },
    onDrag: (vertex, target) => run.movePin(vertex, target),
    onDragEnd: () => {
      run.held.value = null;
    },
    onPull: (pull) => {
      run.pull.value = pull;
    },
    onCameraChange: () => {},
    onContextLost: () => notify('error', 'page.errors.contextLost'),
  };
}
