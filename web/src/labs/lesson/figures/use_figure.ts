import { useEffect, useMemo } from 'preact/hooks';
import { FigureSession, type FigureSettings } from './figure_session.ts';
import { lessonSolver } from './lesson_solver.ts';

/** A figure's session for as long as the component stands on the page. */
export function useFigure(settings: FigureSettings): FigureSession {
  const figure = useMemo(() => new FigureSession(lessonSolver, settings), [settings]);
  useEffect(() => figure.start(), [figure]);
  return figure;
}
