import { effect, useSignalEffect } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { HalfStepAnimation } from '../../app/half_step_animation.ts';
import { areAllLit, highlighted, litThings, nothing } from '../../app/highlight.ts';
import { drawingTime } from '../../app/measurements.ts';
import { notify } from '../../app/notices.ts';
import { pointAtDrawn, pointAway, pointed } from '../../app/pointing.ts';
import { appliedTheme } from '../../app/preferences.ts';
import { dragging, labFigure, liveFrame, playing, r, scene, state } from '../../app/state.ts';
import { followLayout } from '../../views/scene3d/follow_layout.ts';
import { darkPalette, lightPalette } from '../../views/scene3d/palette.ts';
import { Scene3D } from '../../views/scene3d/scene3d.ts';
import type { Hit, Scene3DCallbacks, ViewName } from '../../views/scene3d/types.ts';
import { canvasOrigin, legend, pictures, scene3D } from './stage_signals.ts';

interface Props {
  actions: Actions;
  /** What is to be seen on it. */
  label: string;
}

/** The canvas under the views, and the wiring between it and the state. The views, one or both, are the elements with data-view beside it. */
export function Stage({ actions, label }: Props) {
  const canvas = useRef<HTMLCanvasElement>(null);

  useEffect(() => {
    const element = canvas.current as HTMLCanvasElement;
    let drawing = 0;
    const draw = () => {
      const started = performance.now();
      drawing = 0;
      view.render();
      drawingTime.add(performance.now() - started, started);
      pictures.value++;
      document.body.dataset.ready = 'true';
    };
    const view = new Scene3D(element, {
      ...callbacks(element, actions),
      onInvalidate: () => {
        drawing ||= requestAnimationFrame(draw);
      },
    });
    scene3D.value = view;
    const views = viewsOf(element);
    const stopFollowing = followLayout(
      element,
      views.map((shown) => shown.element),
      (origin, rectangles) => {
        canvasOrigin.value = origin;
        const placeOf = (name: ViewName) => rectangles[views.findIndex((shown) => shown.name === name)] ?? null;
        view.setViewports(placeOf('local'), placeOf('global'));
      },
    );
    return () => {
      stopFollowing();
      cancelAnimationFrame(drawing);
      scene3D.value = null;
      view.dispose();
    };
  }, [actions]);

  // At once, where a signal effect would wait for the next picture: a large scene takes as long to be set as to be drawn.
  useEffect(
    () =>
      effect(() => {
        if (r.value.length === 0) return;
        const { V, E, F, texture } = scene.value;
        pointAway(); // it was at another scene
        scene3D.value?.setScene({ V, E, F, texture, r: r.value });
        const { camera } = state.peek().view;
        if (camera) scene3D.value?.setCamera(camera);
      }),
    [],
  );

  useSignalEffect(() => {
    const { view, selection } = state.value;
    scene3D.value?.setOptions({
      exaggeration: view.exaggeration,
      showSprings: view.springs,
      showSurface: view.surface,
      selected: selection,
      palette: appliedTheme.value === 'dark' ? darkPalette : lightPalette,
    });
  });

  useSignalEffect(() => {
    scene3D.value?.setOptions({
      pointedAt: litThings(labFigure),
      lit: {
        localSprings: areAllLit('spring', 'v'), // v is what the other view draws
        globalSprings: areAllLit('spring', 'd'),
        vertices: areAllLit('vertex'),
      },
    });
  });

  useSignalEffect(() => {
    if (moves()) closeDrawn(canvas.current);
  });

  useEffect(() => {
    const animation = new HalfStepAnimation();
    const stop = liveFrame.subscribe((f) => {
      if (f) animation.show(f, (shown, progress) => scene3D.value?.setFrame(shown, progress));
    });
    return () => {
      stop();
      animation.stop();
    };
  }, []);

  return <canvas ref={canvas} class="stage-canvas" aria-label={label} role="img" />;
}

/** While things move, a card would stay beside a place that its thing has left. */
function moves(): boolean {
  return playing.value || dragging.value !== null;
}

function closeDrawn(canvas: HTMLCanvasElement | null): void {
  if (pointed.peek()?.hook === canvas) pointAway();
}

function callbacks(canvas: HTMLCanvasElement, actions: Actions): Omit<Scene3DCallbacks, 'onInvalidate'> {
  const open = ({ kind, index, bounds }: Hit, by: 'hover' | 'tap') => {
    pointAtDrawn(canvas, bounds, by, { [kind]: index });
  };
  const isTapped = ({ kind, index }: Hit) => {
    const { [kind]: lit, figure } = highlighted.peek();
    return pointed.peek()?.by === 'tap' && figure === labFigure && lit === index;
  };
  return {
    onHover: (hit) => {
      if (hit && !moves()) {
        if (!isTapped(hit)) open(hit, 'hover');
      } else if ((pointed.peek()?.by ?? 'hover') === 'hover') {
        highlighted.value = hit ? { ...nothing, figure: labFigure, [hit.kind]: hit.index } : nothing;
        pointed.value = null;
      }
    },
    onSelect: (hit) => {
      if (hit?.kind === 'spring') actions.selectSpring(hit.index);
      if (hit?.kind === 'vertex') actions.selectVertex(hit.index);
      if (hit && !moves()) open(hit, 'tap');
    },
    onPinToggle: (vertex) => actions.togglePin(vertex, positionOf(vertex)),
    onDragStart: (vertex) => {
      actions.selectVertex(vertex);
      actions.beginDrag(vertex);
    },
    onDrag: (vertex, target) => actions.movePin(vertex, [target[0], target[1], target[2]]),
    onDragEnd: () => actions.endDrag(),
    onCameraChange: (camera) => {
      closeDrawn(canvas);
      actions.setView({ camera });
    },
    onLegend: (next) => {
      legend.value = next;
    },
    onContextLost: () => notify('error', 'page.errors.contextLost'),
  };
}

function positionOf(vertex: number): [number, number, number] {
  const p = liveFrame.peek()?.p ?? scene.peek().V;
  return [p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]];
}

/** Those of the two views that are beside the canvas. */
function viewsOf(canvas: HTMLCanvasElement): { name: ViewName; element: Element }[] {
  const stage = canvas.parentElement as HTMLElement;
  return (['local', 'global'] as const).flatMap((name) => {
    const element = stage.querySelector(`[data-view="${name}"]`);
    return element ? [{ name, element }] : [];
  });
}
