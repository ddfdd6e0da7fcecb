import type { FigureSession } from './figure_session.ts';
import type { Plane } from './plane.ts';

/** Handlers with which a vertex, drawn by the element that they are given to, follows the pointer. */
export function pulling(figure: FigureSession, plane: Plane, vertex: number) {
  return {
    onPointerDown({ currentTarget, pointerId }: PointerEvent) {
      (currentTarget as Element).setPointerCapture(pointerId);
      figure.selectVertex(vertex);
    },
    onPointerMove({ currentTarget, pointerId, clientX, clientY }: PointerEvent) {
      const element = currentTarget as Element;
      const picture = element.closest('.spring-picture');
      if (!picture || !element.hasPointerCapture(pointerId)) return;
      const { left, top } = picture.getBoundingClientRect();
      figure.held.value = { vertex, target: plane.point([clientX - left, clientY - top]) };
    },
    onLostPointerCapture: () => figure.letGo(),
  };
}
