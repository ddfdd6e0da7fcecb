import { CircleGeometry, Color, CustomBlending, DoubleSide, Mesh, ShaderMaterial, Vector2 } from 'three';
import { steps125 } from '../../lib/steps_125.ts';
import type { ArmPalette } from './arm_palette.ts';
import { setInkColour } from './ink.ts';

/** m. */
const gridSteps = steps125(1e-3, 100);
const linesPerReach = 5;
/** How much of what lies below the floor is veiled. */
const veil = 0.45;

/** m: between two lines of the grid. */
export function gridStepOf(reach: number): number {
  return gridSteps.findLast((step) => step <= reach / linesPerReach) ?? gridSteps[0];
}

/** The plane that is drawn on: a grid that fades out, and a veil over what lies below it. */
export class ArmFloor {
  readonly mesh: Mesh<CircleGeometry, ShaderMaterial>;
  private readonly uniforms = {
    centre: { value: new Vector2() },
    radius: { value: 1 },
    gridStep: { value: 1 },
    line: { value: new Color() },
    axis: { value: new Color() },
    background: { value: new Color() },
  };

  constructor() {
    const material = new ShaderMaterial({
      uniforms: this.uniforms,
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      blending: CustomBlending, // and not `transparent`: it is drawn after what is solid and before what lies over everything
      depthWrite: false,
      polygonOffset: true, // what is drawn on the floor lies on it
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 4,
    });
    this.mesh = new Mesh(new CircleGeometry(1, 64).rotateX(-Math.PI / 2), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 0.5;
  }

  /** Under the root; m. */
  place(x: number, z: number, reach: number): void {
    this.uniforms.centre.value.set(x, z);
    this.uniforms.radius.value = floorRadius(reach);
    this.uniforms.gridStep.value = gridStepOf(reach);
  }

  setColours({ grid, axis, background }: ArmPalette): void {
    setInkColour(this.uniforms.line.value, grid);
    setInkColour(this.uniforms.axis.value, axis);
    setInkColour(this.uniforms.background.value, background);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/** m. */
export function floorRadius(reach: number): number {
  return 1.2 * reach;
}

const vertexShader = /* glsl */ `
  uniform vec2 centre;
  uniform float radius;
  varying vec2 place;
  varying vec2 fromCentre;

  void main() {
    fromCentre = position.xz;
    place = centre + radius * fromCentre;
    gl_Position = projectionMatrix * (viewMatrix * vec4(place.x, 0.0, place.y, 1.0));
  }
`;

/** Lines one pixel wide, dropped where they would crowd. */
const fragmentShader = /* glsl */ `
  uniform float gridStep;
  uniform vec3 line;
  uniform vec3 axis;
  uniform vec3 background;
  varying vec2 place;
  varying vec2 fromCentre;

  void main() {
    vec2 cell = place / gridStep;
    vec2 pixel = fwidth(cell);
    vec2 lines = 1.0 - clamp(abs(fract(cell - 0.5) - 0.5) / pixel, 0.0, 1.0);
    vec2 axes = 1.0 - clamp(abs(cell) / pixel - 0.25, 0.0, 1.0);
    lines *= 1.0 - smoothstep(0.2, 0.5, pixel);
    float onAxis = max(axes.x, axes.y);
    float onLine = max(max(lines.x, lines.y), onAxis);
    vec3 colour = mix(background, mix(line, axis, onAxis), onLine);
    float fade = 1.0 - smoothstep(0.35, 1.0, length(fromCentre));
    gl_FragColor = vec4(colour, fade * max(${veil}, onLine));
  }
`;
