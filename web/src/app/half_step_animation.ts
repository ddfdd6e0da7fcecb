import type { Frame } from '../solver/frame.ts';
import { reducedMotion } from './preferences.ts';

/** Long enough to see springs tear and stitch, short enough not to wait for. */
const duration_ms = 350;

/**
 * Plays the tear (local) and the stitch (global) when the cursor moves one half-step forwards. Any other move, playing, and readers who asked for
 * less motion get the finished picture at once.
 */
export class HalfStepAnimation {
  private last: Frame | null = null;
  private request = 0;

  show(next: Frame, draw: (frame: Frame, progress: number) => void): void {
    const { last } = this;
    this.last = next;
    const onward = last !== null && next.step === last.step && next.half_step === last.half_step + 1;
    const samePlace = last !== null && next.step === last.step && next.half_step === last.half_step;
    if (samePlace && this.request !== 0) {
      this.redraw = (progress) => draw(next, progress); // e.g. the rest of the trace arrived: keep animating
      return;
    }
    this.stop();
    if (!onward || next.events.length === 0 || reducedMotion.value) {
      draw(next, 1);
      return;
    }
    this.redraw = (progress) => draw(next, progress);
    const begin = performance.now();
    const tick = (now: number) => {
      const progress = Math.min(1, Math.max(0, (now - begin) / duration_ms));
      this.request = progress < 1 ? requestAnimationFrame(tick) : 0;
      this.redraw(ease(progress));
    };
    tick(begin);
  }

  stop(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
  }

  private redraw: (progress: number) => void = () => {};
}

function ease(x: number): number {
  return x * x * (3 - 2 * x);
}
