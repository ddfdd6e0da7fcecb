import { useEffect, useState } from 'preact/hooks';
import { HalfStepAnimation } from '../../../app/half_step_animation.ts';
import type { Frame } from '../../../solver/frame.ts';
import type { FigureSession } from './figure_session.ts';

/** A frame, and how far its half-step has come in the picture: 0 … 1. */
export interface HalfStep {
  frame: Frame;
  progress: number;
}

/** What a figure shows at this moment, half-steps onwards taking a little time; null before the first picture. */
export function useHalfStep(figure: FigureSession): HalfStep | null {
  const [shown, show] = useState<HalfStep | null>(null);
  useEffect(() => {
    const animation = new HalfStepAnimation();
    const stop = figure.frame.subscribe((next) => {
      if (next) animation.show(next, (frame, progress) => show({ frame, progress }));
    });
    return () => {
      stop();
      animation.stop();
    };
  }, [figure]);
  return shown;
}
