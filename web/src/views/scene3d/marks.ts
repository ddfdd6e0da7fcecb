import { Color } from 'three';
import { type Ink, InkQuads, type Layer, setInkColour } from './ink.ts';

/** Signed distances in device pixels from `point`, of a shape of the given radius. */
const shapes = {
  disc: 'length(point) - radius * pixelRatio',
  diamond: '0.7071 * (abs(point.x) + abs(point.y) - radius * pixelRatio)',
  ring: 'abs(length(point) - radius * pixelRatio) - 1.25 * pixelRatio',
};

/** Points of a size in pixels. */
export class Marks extends InkQuads {
  private readonly uniforms;

  constructor(ink: Ink, capacity: number, shape: keyof typeof shapes, layer: Layer) {
    const uniforms = {
      radius: { value: 1 },
      halo: { value: 0 },
      haloColour: { value: new Color() },
      colour: { value: new Color() },
      presence: { value: 1 },
    };
    const paintShape = `void main() { paint(${shapes[shape]}, colour); }`;
    super(ink, layer, capacity, 1, uniforms, vertexMain, fragmentDeclarations + paintShape);
    this.uniforms = uniforms;
  }

  /** CSS pixels and "#rrggbb". */
  setStyle(style: { radius: number; halo: number; colour: string; haloColour: string }): void {
    this.uniforms.radius.value = style.radius;
    this.uniforms.halo.value = style.halo;
    setInkColour(this.uniforms.colour.value, style.colour);
    setInkColour(this.uniforms.haloColour.value, style.haloColour);
  }

  /** Puts them at rows of points (#×3, metres), one at each. */
  moveTo(points: Float64Array): void {
    for (let mark = 0; mark < points.length / 3; mark++) {
      for (let c = 0; c < 3; c++) this.data[4 * mark + c] = points[3 * mark + c];
    }
    this.commit(points.length / 3);
  }
}

const vertexMain = /* glsl */ `
  uniform float radius;
  varying vec2 point;

  void main() {
    vec3 viewCentre = (modelViewMatrix * vec4(texel(0).xyz, 1.0)).xyz;
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
