import { describe, expect, it } from 'vitest';
import { Clock } from '../../../web/src/app/clock.ts';

interface Playing {
  interval: number;
  pictures: number;
  delta_t: number;
  cost: number;
  /** Of the interval, what drawing takes by itself. */
  drawing?: number;
}

/** Steps due over pictures `interval` ms apart, each step costing `cost` ms. */
function run({ interval, pictures, delta_t, cost, drawing = 10 }: Playing) {
  const clock = new Clock();
  return Array.from({ length: pictures }, (_, picture) => {
    clock.drawn(picture * interval - drawing);
    clock.drawn(picture * interval);
    const steps = clock.due(picture * interval, delta_t);
    if (steps > 0) clock.spent(steps, steps * cost);
    return steps;
  });
}

const sum = (numbers: number[]) => numbers.reduce((total, n) => total + n, 0);

describe('the clock', () => {
  it('keeps pace with the wall clock when the machine can', () => {
    // 600 pictures of 1/60 s are 10 s: 300 steps of 1/30 s, give or take the one that the last picture may still owe
    expect(sum(run({ interval: 1000 / 60, pictures: 601, delta_t: 1 / 30, cost: 1 }))).toBeGreaterThanOrEqual(299);
    expect(sum(run({ interval: 1000 / 60, pictures: 601, delta_t: 1 / 30, cost: 1 }))).toBeLessThanOrEqual(300);
  });

  it('runs several small steps a picture', () => {
    expect(sum(run({ interval: 20, pictures: 101, delta_t: 0.005, cost: 0.5 }))).toBeGreaterThanOrEqual(399);
  });

  it('never asks for more work a picture than its budget, once it knows the cost', () => {
    const quick = run({ interval: 10, pictures: 50, delta_t: 0.001, cost: 5 }).slice(2);
    expect(Math.max(...quick) * 5).toBeLessThanOrEqual(Clock.budget_ms.least);
    const slow = run({ interval: 1000, pictures: 50, delta_t: 0.001, cost: 5 }).slice(2);
    expect(Math.max(...slow) * 5).toBeLessThanOrEqual(Clock.budget_ms.most);
  });

  it('keeps pace, too, where drawing by itself takes long', () => {
    // 50 pictures of 200 ms are 10 s, or 300 steps of 1/30 s. A picture's six cost more than `most`, but less than drawing it.
    const steps = run({ interval: 200, pictures: 51, delta_t: 1 / 30, cost: 22, drawing: 200 });
    expect(6 * 22).toBeGreaterThan(Clock.budget_ms.most);
    expect(sum(steps)).toBeGreaterThanOrEqual(299);
  });

  it('does not take a page that was hidden for one that draws slowly', () => {
    const steps = run({ interval: 60_000, pictures: 10, delta_t: 0.001, cost: 5, drawing: 60_000 }).slice(2);
    expect(Math.max(...steps) * 5).toBeLessThanOrEqual(Clock.budget_ms.picture);
  });

  it('lets a slow machine fall behind instead of owing more and more', () => {
    const steps = run({ interval: 200, pictures: 50, delta_t: 0.02, cost: 200 });
    expect(Math.max(...steps.slice(2))).toBe(1);
  });

  it('forgets the time that passed at rest', () => {
    const clock = new Clock();
    clock.due(0, 0.01);
    clock.rest();
    expect(clock.due(60_000, 0.01)).toBe(0);
  });

  it('begins another scene with a single step, whatever the last one cost', () => {
    const clock = new Clock();
    clock.due(0, 0.01);
    clock.due(50, 0.01);
    clock.spent(5, 0.1);
    clock.reset();
    clock.due(1000, 0.01);
    expect(clock.due(1200, 0.01)).toBe(1);
  });
});
