import { computed } from '@preact/signals';
import { pins, scene } from '../../../app/state.ts';

/** What names the rows and columns of the lab's matrices. */
export interface Numbering {
  /** #E×2. */
  E: Int32Array;
  vertexCount: number;
  pinned: Int32Array;
}

const pinnedVertices = computed(() => pins.value.pinned.join());

/** Ascending: the vertices that are not pinned. */
export function freeVertices({ vertexCount, pinned }: Pick<Numbering, 'vertexCount' | 'pinned'>): Int32Array {
  const fixed = new Set(pinned);
  return Int32Array.from({ length: vertexCount }, (_, vertex) => vertex).filter((vertex) => !fixed.has(vertex));
}

/** Of the lab's present scene and pins; the same object until those are others, wherever the pins are held. */
export const numbering = computed<Numbering>(() => {
  void pinnedVertices.value;
  const { E, m } = scene.value;
  return { E, vertexCount: m.length, pinned: pins.peek().pinned };
});
