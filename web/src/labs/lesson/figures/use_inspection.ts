import { useEffect, useState } from 'preact/hooks';
import type { Frame } from '../../../solver/frame.ts';
import type { Inspection } from '../../../solver/protocol.ts';
import type { FigureSession } from './figure_session.ts';

/** What was seen, and the frame that it belongs to. */
export type Seen = Inspection & { frame: Frame };

const noPoints = () => [];

/**
 * What only a small scene can show whole, of the figure's present moment: matrices, every vertex's equation, and E at the points of interest.
 * `pointsOf` is to be the same function from render to render.
 */
export function useInspection(
  figure: FigureSession,
  pointsOf: (frame: Frame) => readonly Float64Array[] = noPoints,
): Seen | null {
  const [seen, setSeen] = useState<Seen | null>(null);

  useEffect(() => {
    let wanted = true;
    let asking = false;
    let shown: Frame | null = null;
    const follow = async () => {
      if (asking) return;
      asking = true;
      for (let frame = figure.frame.value; wanted && frame && frame !== shown; frame = figure.frame.value) {
        shown = frame;
        const inspection = await figure.inspect(pointsOf(frame));
        if (wanted && inspection) setSeen({ ...inspection, frame });
      }
      asking = false;
    };
    const stop = figure.frame.subscribe(() => void follow());
    return () => {
      wanted = false;
      stop();
    };
  }, [figure, pointsOf]);

  return seen;
}
