import { onFloor } from '../../../app/kinematics_drawing.ts';
import { shape } from '../../../curves/shape.ts';

/** #T×3, m: so many targets on the floor along one of the lab's curves, evenly in its parameter. [P] */
export function questionTargets(curve: 'circle' | 'heart', count: number): Float64Array {
  const { from, to, at } = shape(curve);
  const targets = Array.from({ length: count }, (_, step) => onFloor(at(from + ((to - from) * step) / count)));
  return Float64Array.from(targets.flat());
}
