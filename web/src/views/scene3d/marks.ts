import { Color, DynamicDrawUsage, InstancedBufferAttribute } from 'three';
import { createInkMesh, type Ink, type Layer, setInkColour } from './ink.ts';

/** Signed distances in device pixels from `point`, of a shape of the given radius. */
const shapes = {
  disc: 'length(point) - radius * pixelRatio',
  diamond: '0.7071 * (abs(point.x) + abs(point.y) - radius * pixelRatio)',
  ring: 'abs(length(point) - radius * pixelRatio) - 1.25 * pixelRatio',
};

/** Points of a size in pixels. Fill `centres`, then `commit()`. */
export class Marks {
  /** capacity×3, metres. */
  readonly centres: Float32Array;
  readonly mesh: ReturnType<typeof createInkMesh>;

  private readonly centreAttribute: InstancedBufferAttribute;
  private readonly uniforms = {
    radius: { value: 1 },
    halo: { value: 0 },
    haloColour: { value: new Color() },
    colour: { value: new Color() },
    presence: { value: 1 },
  };

  constructor(ink: Ink, capacity: number, shape: keyof typeof shapes, layer: Layer) {
    this.centres = new Float32Array(3 * capacity);
    this.centreAttribute = new InstancedBufferAttribute(this.centres, 3).setUsage(DynamicDrawUsage);
    const paintShape = `void main() { paint(${shapes[shape]}, colour); }`;
    this.mesh = createInkMesh(ink, this.uniforms, vertexMain, fragmentDeclarations + paintShape, layer);
    this.mesh.geometry.setAttribute('centre', this.centreAttribute);
    this.mesh.geometry.instanceCount = capacity;
  }

  /** CSS pixels and "#rrggbb". */
  setStyle(style: { radius: number; halo: number; colour: string; haloColour: string }): void {
    this.uniforms.radius.value = style.radius;
    this.uniforms.halo.value = style.halo;
    setInkColour(this.uniforms.colour.value, style.colour);
    setInkColour(this.uniforms.haloColour.value, style.haloColour);
  }

  commit(): void {
    this.centreAttribute.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

const vertexMain = /* glsl */ `
  uniform float radius;
  attribute vec3 centre;
  varying vec2 point;

  void main() {
    vec3 viewCentre = (modelViewMatrix * vec4(centre, 1.0)).xyz;
    if (viewCentre.z > -projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0)) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
    point = position.xy * ((radius + halo + 2.0) * pixelRatio + 1.0);
    place(toPixels(viewCentre) + point, viewCentre, 0.5 * haloDepth);
  }
`;

const fragmentDeclarations = /* glsl */ `
  uniform float radius;
  uniform vec3 colour;
  varying vec2 point;
`;
