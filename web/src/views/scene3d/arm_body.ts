import { type BufferGeometry, CylinderGeometry, Group, Matrix4, Quaternion, SphereGeometry, Vector3 } from 'three';
import { kinematicsLimits } from '../../app/kinematics.ts';
import type { ArmPalette } from './arm_palette.ts';
import { Solids } from './solids.ts';

const mostJoints = kinematicsLimits.links.max + 1;
/** Radius of the first link, as shares of the arm's reach and of its mean link, whichever is less; of the last, as a share of the first's. */
const thickness = { reach: 0.014, link: 0.11, last: 0.65 };
/** Radii in those of the link that begins there. */
const jointSize = 1.5;
const linkEnd = 0.75;
/** Radii: rod and plate that the root hangs from, or stands on. */
const mount = { rod: 0.6, rodLength: 4, plate: 4, plateThickness: 0.5 };

const up = new Vector3(0, 1, 0);

/** The solid arm: a tapering link from each joint to the next, joints as balls, and what holds the root. Allocates its shapes once. */
export class ArmBody {
  readonly group = new Group();
  private readonly links = new Solids(rod(linkEnd), mostJoints - 1);
  private readonly joints = new Solids(new SphereGeometry(1, 24, 16), mostJoints);
  private readonly mount = new Solids(rod(1, false), 2);
  // What every picture is computed in.
  private readonly matrix = new Matrix4();
  private readonly from = new Vector3();
  private readonly to = new Vector3();
  private readonly turn = new Quaternion();
  private readonly size = new Vector3();

  constructor() {
    this.group.add(this.links, this.joints, this.mount);
  }

  /** `x` #joints×3, m; `root` where the arm is mounted, m; `radius` of its first link, m; `turned`: a joint to mark, or null. */
  show(x: Float64Array, root: ArrayLike<number>, radius: number, turned: number | null, palette: ArmPalette): void {
    const count = x.length / 3;
    this.links.count = count - 1;
    this.joints.count = count;
    for (let i = 0; i < count; i++) {
      const here = radius * (1 - (1 - thickness.last) * (i / count));
      const last = i === count - 1;
      this.from.fromArray(x, 3 * i);
      if (!last) this.place(this.links, i, this.from, this.to.fromArray(x, 3 * i + 3), here);
      this.matrix.makeScale(jointSize * here, jointSize * here, jointSize * here).setPosition(this.from);
      this.joints.setMatrixAt(i, this.matrix);
      this.joints.paint(i, i === turned ? palette.turned : last ? palette.effector : palette.joint);
      if (!last) this.links.paint(i, palette.link);
    }
    this.showMount(root, radius, palette);
    for (const solids of [this.links, this.joints, this.mount]) {
      solids.setBackground(palette.background);
      solids.refresh();
    }
  }

  dispose(): void {
    for (const solids of [this.links, this.joints, this.mount]) solids.dispose();
  }

  /** From the ceiling where the root is above the floor, else from what lies below it. */
  private showMount(root: ArrayLike<number>, radius: number, { mount: colour }: ArmPalette): void {
    const side = root[1] > 0 ? 1 : -1;
    this.from.fromArray(root);
    this.to.copy(this.from).addScaledVector(up, side * mount.rodLength * radius);
    this.place(this.mount, 0, this.from, this.to, mount.rod * radius);
    this.from.copy(this.to).addScaledVector(up, side * mount.plateThickness * radius);
    this.place(this.mount, 1, this.to, this.from, mount.plate * radius);
    for (const part of [0, 1]) this.mount.paint(part, colour);
  }

  private place(solids: Solids, index: number, from: Vector3, to: Vector3, radius: number): void {
    this.size.subVectors(to, from);
    const length = this.size.length();
    this.turn.setFromUnitVectors(up, length > 0 ? this.size.divideScalar(length) : up);
    solids.setMatrixAt(index, this.matrix.compose(from, this.turn, this.size.set(radius, length, radius)));
  }
}

/** m: of the first link. */
export function radiusOf(reach: number, links: number): number {
  return Math.min(thickness.reach * reach, (thickness.link * reach) / links);
}

/** One unit high from the origin up, of radius 1 at its foot; open where balls close it. */
function rod(top: number, open = true): BufferGeometry {
  return new CylinderGeometry(top, 1, 1, 24, 1, open).translate(0, 0.5, 0);
}
