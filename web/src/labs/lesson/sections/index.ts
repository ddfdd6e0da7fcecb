import type { ComponentType } from 'preact';
import type { SectionId } from '../../../notation/sections.ts';
import { formulaFonts } from '../../../views/equations/formula_fonts.ts';

/** Each section is loaded when it is opened, and shown once its formulas can be set. */
export const sections: Record<SectionId, () => Promise<ComponentType>> = {
  model: () => settable(async () => (await import('./model/model.tsx')).Model),
  energy: () => settable(async () => (await import('./energy/energy.tsx')).Energy),
  time: () => settable(async () => (await import('./time/time.tsx')).Time),
  optimisation: () => settable(async () => (await import('./optimisation/optimisation.tsx')).Optimisation),
  trick: () => settable(async () => (await import('./trick/trick.tsx')).Trick),
  matrices: () => settable(async () => (await import('./matrices/matrices.tsx')).Matrices),
  solving: () => settable(async () => (await import('./solving/solving.tsx')).Solving),
  sparse: () => settable(async () => (await import('./sparse/sparse.tsx')).Sparse),
  pins: () => settable(async () => (await import('./pins/pins.tsx')).Pins),
  tasks: () => settable(async () => (await import('./tasks/tasks.tsx')).Tasks),
};

async function settable(load: () => Promise<ComponentType>): Promise<ComponentType> {
  const Content = await load(); // with it comes the style sheet that knows the fonts
  await formulaFonts();
  return Content;
}
