import { describe, expect, it } from 'vitest';
import { floorMove, spaceMove } from '../../../../web/src/views/scene3d/arm_keys.ts';

type Vector = [number, number, number];
const looking = (position: Vector) => ({ position, target: [0, 0, 0] as Vector });
const fromFront = looking([0, 0, 5]);
const press = (key: string, shiftKey = false) => ({ key, shiftKey });
/** m: one centimetre, up to rounding. */
function expectMove(move: readonly number[] | null, wanted: readonly number[]): void {
  wanted.forEach((value, axis) => {
    expect(move?.[axis]).toBeCloseTo(value, 15);
  });
}

describe('spaceMove', () => {
  it('moves as the reader sees it, a centimetre a press and ten with Shift', () => {
    expectMove(spaceMove(press('ArrowRight'), fromFront), [0.01, 0, 0]);
    expectMove(spaceMove(press('ArrowUp', true), fromFront), [0, 0.1, 0]);
    expectMove(spaceMove(press('PageUp'), fromFront), [0, 0, -0.01]);
    expectMove(spaceMove(press('PageDown'), fromFront), [0, 0, 0.01]);
    expectMove(spaceMove(press('ArrowRight'), looking([5, 0, 0])), [0, 0, -0.01]);
  });

  it('means nothing by other keys', () => {
    expect(spaceMove(press('r'), fromFront)).toBeNull();
  });
});

describe('floorMove', () => {
  it('moves along the curve’s axes: up is away from a reader in front', () => {
    const above = looking([0, 4, 5]);
    expectMove(floorMove(press('ArrowRight'), above), [0.01, 0]);
    expectMove(floorMove(press('ArrowUp'), above), [0, 0.01]);
    expectMove(floorMove(press('ArrowDown', true), above), [0, -0.1]);
  });

  it('follows the camera by quarter turns, so that lines stay parallel to the axes', () => {
    const aside = looking([2, 4, 5]);
    expectMove(floorMove(press('ArrowRight'), aside), [0.01, 0]);
    const behind = looking([0, 4, -5]);
    expectMove(floorMove(press('ArrowRight'), behind), [-0.01, 0]);
    expectMove(floorMove(press('ArrowUp'), behind), [0, -0.01]);
    const fromRight = looking([5, 4, 0]); // sees +y of the curve to its right, and −x ahead
    expectMove(floorMove(press('ArrowRight'), fromRight), [0, 0.01]);
    expectMove(floorMove(press('ArrowUp'), fromRight), [-0.01, 0]);
  });
});
