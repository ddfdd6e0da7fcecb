import { norm, row, subtract } from '../../lib/vector.ts';
import type { Frame } from '../../solver/frame.ts';

/** ‖p_i − p_before,i‖, m: how far the half-step at the cursor moved a vertex. */
export function vertexMove(frame: Frame, vertex: number): number {
  return norm(subtract(row(frame.p, vertex), row(frame.pBefore, vertex)));
}
