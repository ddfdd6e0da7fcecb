import { type InstancedMesh, Matrix4, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { ArmBody, radiusOf } from '../../../../web/src/views/scene3d/arm_body.ts';
import { lightArmPalette } from '../../../../web/src/views/scene3d/arm_palette.ts';
import type { Solids } from '../../../../web/src/views/scene3d/solids.ts';

const x = Float64Array.of(0, 1.7, 0, 0.3, 0.9, 0.1, 0.3, 0.4, 0.1, 0.5, 0.2, -0.9);
/** Instances are kept in single precision: this much of numbers about 1. */
const single = 6; // decimals

function placed(mesh: InstancedMesh, index: number, point: Vector3): Vector3 {
  const matrix = new Matrix4();
  mesh.getMatrixAt(index, matrix);
  return point.applyMatrix4(matrix);
}

it('links span from joint to joint, also straight down, and balls sit at the joints', () => {
  const body = new ArmBody();
  body.show(x, [0, 1.7, 0], radiusOf(2.6, 3), null, lightArmPalette);
  const [links, joints] = body.group.children as Solids[];
  expect([links.count, joints.count]).toEqual([3, 4]);
  for (let i = 0; i < 4; i++) {
    const joint = new Vector3().fromArray(x, 3 * i);
    expect(placed(joints, i, new Vector3()).distanceTo(joint)).toBeCloseTo(0, single);
    if (i === 3) break;
    expect(placed(links, i, new Vector3()).distanceTo(joint)).toBeCloseTo(0, single);
    const next = new Vector3().fromArray(x, 3 * i + 3);
    expect(placed(links, i, new Vector3(0, 1, 0)).distanceTo(next)).toBeCloseTo(0, single);
  }
  body.dispose();
});

it('an arm of many short links is thinner than its links are long', () => {
  expect(radiusOf(2.6, 20)).toBeLessThan(2.6 / 20 / 4);
});
