import type { Actions } from '../../app/actions.ts';
import { pins, scene } from '../../app/state.ts';
import { PinHandle } from '../../views/scene3d/pin_handle.tsx';
import { canvasOrigin, pictures, scene3D } from './stage_signals.ts';

/** The lab's pins for the keyboard, where the global view draws them. */
export function LabPinHandle({ actions }: { actions: Actions }) {
  const view = scene3D.value;
  if (!view) return null;
  return (
    <PinHandle
      pins={pins.value}
      V={scene.value.V}
      camera={() => view.camera}
      placeOf={placeInStage}
      pictures={pictures}
      onMove={(vertex, target) => actions.movePin(vertex, target)}
      onFocus={(vertex) => actions.selectVertex(vertex)}
    />
  );
}

function placeInStage(vertex: number) {
  const { x, y } = canvasOrigin.value;
  const place = scene3D.value?.projectToScreen(vertex, 'global');
  return place ? { x: x + place.x, y: y + place.y } : null;
}
