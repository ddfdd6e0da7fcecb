import type { ReadonlySignal } from '@preact/signals';
import type { Axis } from '../notation/symbols.ts';
import type { Scene } from '../scene/scene.ts';
import type { Frame } from '../solver/frame.ts';
import type { MinimisingParameters } from '../solver/module.ts';
import type { Selection } from './state.ts';

/** A simulation on the page – the lab's, or that of a picture in the lesson – as its formulas, matrices and code see it. */
export interface Figure {
  readonly scene: ReadonlySignal<Scene>;
  /** #E, m: rest lengths. */
  readonly r: ReadonlySignal<Float64Array>;
  readonly frame: ReadonlySignal<Frame | null>;
  readonly parameters: ReadonlySignal<MinimisingParameters>;
  readonly selection: ReadonlySignal<Selection>;
}

/** How many rows or columns there are along an axis. */
export function countAlong(axis: Axis, { scene, frame }: Figure): number {
  switch (axis) {
    case '#E':
      return scene.value.E.length / 2;
    case '#V':
      return scene.value.m.length;
    case '#pinned':
      return frame.value?.pinned.length ?? 0;
    case '3#V':
      return 3 * scene.value.m.length;
    case '3#free':
      return 3 * (scene.value.m.length - (frame.value?.pinned.length ?? 0));
    default:
      return Number(axis);
  }
}
