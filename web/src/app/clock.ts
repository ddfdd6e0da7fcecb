/** Simulated time against the wall clock: how many time steps are due. */
export class Clock {
  private last: number | null = null;
  private owed_ms = 0;
  private step_ms = 1;
  private lastPicture = 0;
  private picture_ms = 0;

  /**
   * Longest stretch of work a picture waits for, ms: beyond it the simulation runs slower than real time. The worker computes while the page draws,
   * so a page that draws slowly leaves it more time: up to what still looks like motion, or as long as a picture takes without waiting, but no
   * longer than `picture`, since a page that was hidden seems to have taken hours for one.
   */
  static readonly budget_ms = { least: 14, most: 100, picture: 400 };

  /** To be told of every picture, whether or not it waits for work: at time `now` (ms). */
  drawn(now: number): void {
    this.picture_ms = now - this.lastPicture;
    this.lastPicture = now;
  }

  /** Steps to run now, at time `now` (ms), for a time step of `delta_t` seconds. 0 when none is due. */
  due(now: number, delta_t: number): number {
    const elapsed = this.last === null ? 0 : now - this.last;
    this.last = now;
    this.owed_ms += elapsed;
    const period = delta_t * 1000;
    const { least, most, picture } = Clock.budget_ms;
    const budget = Math.min(Math.max(most, Math.min(picture, this.picture_ms)), Math.max(least, elapsed));
    const affordable = Math.max(1, Math.floor(budget / this.step_ms));
    const steps = Math.min(Math.floor(this.owed_ms / period), affordable);
    if (steps === 0) return 0;
    // Debt that cannot be paid is forgiven, or a slow machine would never catch up.
    this.owed_ms = Math.min(this.owed_ms - steps * period, period);
    return steps;
  }

  /** What the steps really cost, so that the next picture asks for as many as fit. */
  spent(steps: number, milliseconds: number): void {
    this.step_ms = Math.max(0.01, milliseconds / steps);
  }

  /** Forget the time that passed while standing still. */
  rest(): void {
    this.last = null;
    this.owed_ms = 0;
  }

  /** Another scene: what its steps cost is not known, so the first request is for one. */
  reset(): void {
    this.rest();
    this.step_ms = Clock.budget_ms.most;
  }
}
