import { Color, Group } from 'three';
import { steps125 } from '../../lib/steps_125.ts';
import type { ArmPalette } from './arm_palette.ts';
import { type Ink, setInkColour } from './ink.ts';
import { joining } from './segment_ends.ts';
import { Segments } from './segments.ts';
import { Table } from './table.ts';

/** m. */
const gridSteps = steps125(1e-3, 100);
const linesPerReach = 5;
/** Of the reach: how far the grid goes, and the share of that from which on it fades. */
const extent = 1.2;
const fadeFrom = 0.3;
/** More pieces of lines than there ever are: the grid's lines are cut at one another. */
export const mostPieces = 2048;

/** m: between two lines of the grid. */
export function gridStepOf(reach: number): number {
  return gridSteps.findLast((step) => step <= reach / linesPerReach) ?? gridSteps[0];
}

/** m. */
export function floorRadius(reach: number): number {
  return extent * reach;
}

/** #pieces×2×3, m: both ends of every piece of the grid's lines within a circle about (x, z); the axes of x and z come last, and how many of them there are. */
export function gridPieces(x: number, z: number, reach: number): { ends: number[]; axes: number } {
  const step = gridStepOf(reach);
  const radius = floorRadius(reach);
  const [usual, onAxis]: [number[], number[]] = [[], []];
  for (let i = Math.ceil((x - radius) / step); i * step <= x + radius; i++) {
    for (let j = Math.ceil((z - radius) / step); j * step <= z + radius; j++) {
      if (Math.hypot(i * step - x, j * step - z) > radius) continue;
      (j === 0 ? onAxis : usual).push(i * step, 0, j * step, (i + 1) * step, 0, j * step);
      (i === 0 ? onAxis : usual).push(i * step, 0, j * step, i * step, 0, (j + 1) * step);
    }
  }
  return { ends: [...usual, ...onAxis], axes: onAxis.length / 6 };
}

/** The plane that is drawn on, as a grid that fades out. */
export class ArmFloor {
  readonly group = new Group();
  private readonly points = new Table(3);
  private readonly pairs = new Table(2);
  private readonly uniforms = {
    centreX: { value: 0 },
    centreZ: { value: 0 },
    radius: { value: 1 },
    line: { value: new Color() },
    axis: { value: new Color() },
    firstAxis: { value: 0 },
  };
  private readonly lines: Segments;

  constructor(ink: Ink) {
    const fading = { uniforms: { ...this.uniforms, floorPoints: this.points.uniform }, code: fadingCode };
    this.lines = new Segments(ink, 'ghost', mostPieces, joining(this.pairs, this.points, this.points), fading);
    this.lines.mesh.renderOrder -= 1; // before all that stands on it
    this.lines.setStyle({ width: 1 });
    this.group.add(this.lines.mesh);
  }

  /** Under the root; m. */
  place(x: number, z: number, reach: number): void {
    const { ends, axes } = gridPieces(x, z, reach);
    const count = ends.length / 6;
    this.points.set(ends);
    this.pairs.set(Array.from({ length: 2 * count }, (_, at) => at));
    this.lines.show(0, count);
    this.uniforms.centreX.value = x;
    this.uniforms.centreZ.value = z;
    this.uniforms.radius.value = floorRadius(reach);
    this.uniforms.firstAxis.value = count - axes;
  }

  setStyle({ grid, axis }: ArmPalette): void {
    setInkColour(this.uniforms.line.value, grid);
    setInkColour(this.uniforms.axis.value, axis);
  }

  dispose(): void {
    this.lines.dispose();
    this.points.dispose();
    this.pairs.dispose();
  }
}

/** Every piece has one colour, that of its middle. */
const fadingCode = /* glsl */ `
  uniform sampler2D floorPoints;
  uniform float centreX;
  uniform float centreZ;
  uniform float radius;
  uniform vec3 line;
  uniform vec3 axis;
  uniform int firstAxis;
  uniform vec3 background;

  vec3 colourOf(int segment) {
    vec3 middle = 0.5 * (row(floorPoints, 2 * segment) + row(floorPoints, 2 * segment + 1)).xyz;
    float away = distance(middle.xz, vec2(centreX, centreZ)) / radius;
    return mix(segment < firstAxis ? line : axis, background, smoothstep(${fadeFrom.toFixed(2)}, 1.0, away));
  }
`;
