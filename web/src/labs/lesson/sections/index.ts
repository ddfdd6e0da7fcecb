import type { ComponentType } from 'preact';
import type { SectionId } from '../../../notation/sections.ts';

/** Each section is loaded when it is opened. */
export const sections: Record<SectionId, () => Promise<ComponentType>> = {
  model: async () => (await import('./model/model.tsx')).Model,
  energy: async () => (await import('./energy/energy.tsx')).Energy,
  time: async () => (await import('./time/time.tsx')).Time,
  optimisation: async () => (await import('./optimisation/optimisation.tsx')).Optimisation,
  trick: async () => (await import('./trick/trick.tsx')).Trick,
  matrices: async () => (await import('./matrices/matrices.tsx')).Matrices,
  solving: async () => (await import('./solving/solving.tsx')).Solving,
  sparse: async () => (await import('./sparse/sparse.tsx')).Sparse,
  pins: async () => (await import('./pins/pins.tsx')).Pins,
  tasks: async () => (await import('./tasks/tasks.tsx')).Tasks,
};
