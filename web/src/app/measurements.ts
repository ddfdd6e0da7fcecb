import { signal } from '@preact/signals';
import type { Profile } from '../solver/frame.ts';

/** ms: a number that changes faster cannot be read. */
const period_ms = 500;

/** The mean of what has happened since it was last said. */
export class Mean {
  private readonly said = signal<number | null>(null);
  private since = Number.NEGATIVE_INFINITY;
  private sum = 0;
  private count = 0;

  get value(): number | null {
    return this.said.value;
  }

  /** `now`: ms of any one clock. */
  add(value: number, now: number): void {
    this.sum += value;
    this.count += 1;
    if (now - this.since < period_ms) return;
    this.said.value = this.sum / this.count;
    this.since = now;
    this.sum = 0;
    this.count = 0;
  }
}

/** ms of the main thread that one picture of both views takes. */
export const drawingTime = new Mean();

/** ms of the worker that one time step takes while playing, reading out the frame included. */
export const playedStep = new Mean();

/** What one iteration takes at present. */
export const iterationTime = signal<Profile | null>(null);
