import type { Scene3DFrame } from './types.ts';

/** What the two views show of a frame. Nothing moves in both at once: local tears the left view, global stitches the right one. */
export interface Stage {
  /** #V×3: the net whose springs are projected, in the local view. */
  torn: Float64Array;
  /** #E×3: their projections, or null while nothing is torn. */
  d: Float64Array | null;
  /** 0 whole … 1 projected. */
  tear: number;
  /** #V×3: the global view's net is (1 − move) from + move to. */
  from: Float64Array;
  to: Float64Array;
  move: number;
  /** #V×3: where this half-step's movement is drawn from or to, or null when it moves no vertex. */
  ghost: Float64Array | null;
  /** 0 … 1: how far ghost and arrows have come out. */
  reveal: number;
  /** Whether arrows point to the ghost (a prediction) or from it (a place left behind). */
  towardsGhost: boolean;
}

export interface StagedFrame {
  frame: Scene3DFrame;
  stage: Stage;
}

/** A pure function of the frame and of how much of its animation has passed, 0 … 1. */
export function stageOf(frame: Scene3DFrame, progress: number): Stage {
  const { phase, p, pBefore, d } = frame;
  const still = { from: p, to: p, move: 1, ghost: null, reveal: 0, towardsGhost: false };
  switch (phase) {
    case 'predict':
      return {
        ...still,
        torn: p,
        d: null,
        tear: 0,
        ghost: predictionOfFree(frame),
        reveal: progress,
        towardsGhost: true,
      };
    case 'local':
      return { ...still, torn: p, d, tear: progress };
    case 'global':
      return {
        torn: pBefore,
        d,
        tear: 1,
        from: pBefore,
        to: p,
        move: progress,
        ghost: pBefore,
        reveal: progress,
        towardsGhost: false,
      };
    case 'accept':
      return { ...still, torn: pBefore, d, tear: 1 };
  }
}

/** Inertia and forces cannot carry a pin anywhere. */
function predictionOfFree({ p, prediction, pinned }: Scene3DFrame): Float64Array {
  const carried = prediction.slice();
  for (const v of pinned) carried.set(p.subarray(3 * v, 3 * v + 3), 3 * v);
  return carried;
}
