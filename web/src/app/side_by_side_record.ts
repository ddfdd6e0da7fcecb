import { farthest } from '../solver/farthest.ts';
import type { MechanicalEnergy } from '../solver/module.ts';
import type { VariantState } from '../solver/side_by_side.ts';

/** J, after a time step. */
export interface EnergySample extends MechanicalEnergy {
  /** Time steps since the start. */
  step: number;
  /** Simulated s since the start. */
  time: number;
  /** How often methods, settings or motions had been changed from outside: between two such changes the method alone moves the energy. */
  stretch: number;
}

export interface DistanceSample {
  /** Simulated s since the start. */
  time: number;
  /** Max_i ‖p_i − q_i‖, m. */
  distance: number;
}

/** Samples of a curve: 10 s of time steps of 5 ms; earlier ones are dropped. */
const kept = 2000;

/** Of a new measurement: single ones jump about. */
const share = 0.1;

/** What variants side by side have been through lately. */
export class SideBySideRecord {
  energies: EnergySample[][] = [];
  distances: DistanceSample[][] = [];
  /** Wall-clock ms of a time step of each lately; null before the first. */
  milliseconds: (number | null)[] = [];
  private step = 0;
  private time = 0;
  private stretch = 0;

  begin(variants: number): void {
    this.energies = Array.from({ length: variants }, () => []);
    this.distances = Array.from({ length: variants }, () => []);
    this.milliseconds = Array.from({ length: variants }, () => null);
    this.step = 0;
    this.time = 0;
    this.stretch = 0;
  }

  /** What comes next does not follow from what was. */
  interrupt(): void {
    this.stretch += 1;
  }

  /** `from`: which of the curves each variant goes on with; null where it begins one. */
  reorder(from: readonly (number | null)[]): void {
    this.interrupt();
    this.energies = from.map((before) => (before === null ? [] : this.energies[before]));
    this.distances = from.map((before) => (before === null ? [] : this.distances[before]));
    this.milliseconds = from.map(() => null); // with other settings it takes another time
  }

  forgetDistances(): void {
    this.distances = this.distances.map(() => []);
  }

  /** After so many time steps of delta_t, s. One that stands still adds nothing more. */
  add(states: readonly VariantState[], steps: number, delta_t: number, reference: number): void {
    const time = this.time + steps * delta_t;
    states.forEach(({ p, energies, milliseconds, failure }, at) => {
      const before = this.milliseconds[at] ?? milliseconds;
      if (!failure) this.milliseconds[at] = before + share * (milliseconds - before);
      energies.forEach((energy, n) => {
        const [step, sampled] = [this.step + n + 1, this.time + (n + 1) * delta_t];
        this.energies[at].push({ ...energy, step, time: sampled, stretch: this.stretch });
      });
      if (!failure && !states[reference].failure)
        this.distances[at].push({ time, distance: farthest(p, states[reference].p) });
    });
    for (const curve of [...this.energies, ...this.distances]) curve.splice(0, curve.length - kept);
    this.step += steps;
    this.time = time;
  }
}
