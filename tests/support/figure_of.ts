import { signal } from '@preact/signals';
import type { Figure } from '../../web/src/app/figure.ts';
import type { Selection } from '../../web/src/app/state.ts';
import { readFrame } from '../../web/src/solver/read_frame.ts';
import { expectOk, solver } from './open_simulation.ts';
import { type SmallScene, usualParameters } from './small_scenes.ts';

/** A figure of the scene with its cursor at a half-step of the first time step. */
export function figureOf(scene: SmallScene, selection: Selection, half_step: number): Figure {
  const simulation = new solver.Simulation();
  expectOk(simulation.set_scene(scene.V, scene.E, scene.m, scene.pinned, usualParameters));
  expectOk(simulation.seek(half_step));
  const figure = {
    scene: signal({ ...scene, ...usualParameters, name: '', F: new Uint32Array(0), texture: null, damping: 0 }),
    r: signal(simulation.r().slice()),
    frame: signal(readFrame(simulation, { pinned: scene.pinned, selectedVertex: selection.vertex, events: true })),
    parameters: signal(usualParameters),
    selection: signal(selection),
  };
  simulation.delete();
  return figure;
}
