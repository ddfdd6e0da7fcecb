import { vi } from 'vitest';

/** A clock that stands still until told otherwise, in place of the page's. */
export class FakeClock {
  private now = 0;

  constructor() {
    vi.spyOn(performance, 'now').mockImplementation(() => this.now);
  }

  pass(milliseconds: number): void {
    this.now += milliseconds;
  }
}
