import { useMemo } from 'preact/hooks';
import type { FigureSession, FigureSettings } from './figure_session.ts';
import { useFigures } from './use_figures.ts';

/** A figure's session for as long as the component stands on the page. `settings` is to be a constant of the module. */
export function useFigure(settings: FigureSettings): FigureSession {
  const alone = useMemo(() => [settings], [settings]);
  return useFigures(alone)[0];
}
