import { useEffect, useMemo } from 'preact/hooks';
import { FigureSession, type FigureSettings } from './figure_session.ts';
import { lessonSolver } from './lesson_solver.ts';

/** Sessions of figures that are to be compared, for as long as the component stands on the page. `settings` is to be a constant of the module. */
export function useFigures(settings: readonly FigureSettings[]): readonly FigureSession[] {
  const figures = useMemo(() => settings.map((one) => new FigureSession(lessonSolver, one)), [settings]);
  useEffect(() => {
    const stops = figures.map((figure) => figure.start());
    return () => {
      for (const stop of stops) stop();
    };
  }, [figures]);
  return figures;
}
