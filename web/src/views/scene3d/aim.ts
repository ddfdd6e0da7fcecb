import type { Actions } from '../../app/actions.ts';
import { rounded } from './arm_geometry.ts';

/** Moves the arm's target at most once a picture: pointers and held keys may ask more often. */
export class Aim {
  private readonly actions: Pick<Actions, 'setKinematics'>;
  private wanted: readonly number[] | null = null;

  constructor(actions: Pick<Actions, 'setKinematics'>) {
    this.actions = actions;
  }

  /** #3, m. */
  to(target: readonly number[]): void {
    if (!this.wanted) requestAnimationFrame(() => this.apply());
    this.wanted = target;
  }

  /** From where it is on its way to, or else from `here`. */
  by(step: readonly number[], here: readonly number[]): void {
    const from = this.wanted ?? here;
    this.to(from.map((value, axis) => value + step[axis]));
  }

  private apply(): void {
    if (this.wanted) this.actions.setKinematics({ mode: 'aim', target: rounded(this.wanted) });
    this.wanted = null;
  }
}
