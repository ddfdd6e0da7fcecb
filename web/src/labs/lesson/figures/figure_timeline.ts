import type { Checkpoint, Command } from '../../../solver/protocol.ts';

/** Where the cursor goes: by a command, or to a moment known already. */
export type Move = Command | { kind: 'jump'; to: Checkpoint };

/** Time steps that can be gone back to. */
const longestPast = 1000;

/** Where a figure stands and where it has been: between two requests the solver remembers nothing of it. */
export class FigureTimeline {
  /** Null before the first picture. */
  here: Checkpoint | null = null;
  /** The ends of earlier time steps, the oldest first. */
  past: readonly Checkpoint[] = [];

  /** Where a move starts from, and what the solver is to do there. */
  begin(move: Move): { from: Checkpoint | null; command: Command } {
    const stay: Command = { kind: 'stay' };
    if (move.kind === 'jump') {
      this.past = [];
      return { from: move.to, command: stay };
    }
    const back = move.kind === 'previous_step' || (move.kind === 'previous_half_step' && this.here?.half_step === 0);
    if (!back) return { from: this.here, command: move };
    const from = this.past.at(-1) ?? this.here;
    this.past = this.past.slice(0, -1);
    return { from, command: stay };
  }

  /** The solver stands here now; the time step that it comes from ended with `last_half_step`. */
  reach(checkpoint: Checkpoint, last_half_step: number): void {
    if (this.here && checkpoint.step > this.here.step)
      this.past = [...this.past.slice(1 - longestPast), { ...this.here, half_step: last_half_step }];
    this.here = checkpoint;
  }
}
