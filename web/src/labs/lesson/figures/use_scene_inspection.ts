import { useEffect, useState } from 'preact/hooks';
import { notifyOf } from '../../../app/explanation.ts';
import { findScene, type librarySceneNames } from '../../../app/scene_library.ts';
import { parametersOn, pinsOn } from '../../../app/state.ts';
import type { Scene } from '../../../scene/scene.ts';
import type { Inspection } from '../../../solver/protocol.ts';
import { lessonSolver } from './lesson_solver.ts';

export interface InspectedScene extends Inspection {
  scene: Scene;
}

/** A scene of the library at rest, with its own parameters, and its matrices; null until they are known. A notice says why they cannot be. */
export function useSceneInspection(name: (typeof librarySceneNames)[number]): InspectedScene | null {
  const [inspected, setInspected] = useState<InspectedScene | null>(null);
  useEffect(() => {
    inspectScene(name).then(setInspected).catch(notifyOf);
  }, [name]);
  return inspected;
}

async function inspectScene(name: string): Promise<InspectedScene | null> {
  const scene = await findScene(name);
  const request = {
    parameters: parametersOn(scene, {}),
    pins: pinsOn(scene, null),
    command: { kind: 'stay' },
    selectedVertex: null,
    wholeTrace: false,
    profile: false,
  } as const;
  const inspection = await lessonSolver.inspect({ problem: scene, request, from: null }, []);
  return inspection && { scene, ...inspection };
}
