import { Color } from 'three';
import { type Ink, InkQuads, type Layer, setInkColour } from './ink.ts';
import type { Table } from './table.ts';

/** Signed distances in device pixels from `point`, of a shape of the given radius. */
const shapes = {
  disc: 'length(point) - radius * pixelRatio',
  diamond: '0.7071 * (abs(point.x) + abs(point.y) - radius * pixelRatio)',
  ring: 'abs(length(point) - radius * pixelRatio) - 1.25 * pixelRatio',
};

/** Points of a size in pixels, one at each row of a table of points (#×3, metres). */
export class Marks extends InkQuads {
  private readonly uniforms;

  constructor(ink: Ink, layer: Layer, capacity: number, shape: keyof typeof shapes, points: Table) {
    const uniforms = {
      points: points.uniform,
      radius: { value: 1 },
      halo: { value: 0 },
      haloColour: { value: new Color() },
      colour: { value: new Color() },
      presence: { value: 1 },
    };
    const paintShape = `void main() { paint(${shapes[shape]}, colour); }`;
    super(ink, layer, capacity, uniforms, vertexMain, fragmentDeclarations + paintShape);
    this.uniforms = uniforms;
  }

  /** CSS pixels and "#rrggbb". */
  setStyle(style: { radius: number; halo: number; colour: string; haloColour: string }): void {
    this.uniforms.radius.value = style.radius;
    this.uniforms.halo.value = style.halo;
    setInkColour(this.uniforms.colour.value, style.colour);
    setInkColour(this.uniforms.haloColour.value, style.haloColour);
  }
}

const vertexMain = /* glsl */ `
  uniform sampler2D points;
  uniform float radius;
  varying vec2 point;

  void main() {
    vec3 viewCentre = (modelViewMatrix * vec4(row(points, shapeIndex()).xyz, 1.0)).xyz;
    if (viewCentre.z > -nearPlane()) { hide(); return; }
    point = corner() * ((radius + halo + 2.0) * pixelRatio + 1.0);
    place(toPixels(viewCentre) + point, viewCentre, 0.5 * haloDepth);
  }
`;

const fragmentDeclarations = /* glsl */ `
  uniform float radius;
  uniform vec3 colour;
  varying vec2 point;
`;
