/** Max_i ‖p_i − q_i‖ of #V×3 positions, m. */
export function farthest(p: Float64Array, q: Float64Array): number {
  let most = 0;
  for (let at = 0; at < p.length; at += 3)
    most = Math.max(most, Math.hypot(p[at] - q[at], p[at + 1] - q[at + 1], p[at + 2] - q[at + 2]));
  return most;
}
