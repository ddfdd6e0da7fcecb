import { type BufferGeometry, Color, InstancedMesh, ShaderMaterial } from 'three';
import { softLight } from './soft_light.ts';

/** How much of what lies on the other side of the floor, y = 0, is veiled. */
const veil = 0.5;

/** Copies of one solid shape, each of its own size, place and colour, in soft light. */
export class Solids extends InstancedMesh<BufferGeometry, ShaderMaterial> {
  private readonly given = new Color();

  constructor(shape: BufferGeometry, capacity: number) {
    super(
      shape,
      new ShaderMaterial({ uniforms: { background: { value: new Color() } }, vertexShader, fragmentShader }),
      capacity,
    );
    this.frustumCulled = false;
    for (let i = 0; i < capacity; i++) this.setColorAt(i, this.given);
  }

  /** "#rrggbb". */
  paint(index: number, colour: string): void {
    this.setColorAt(index, this.given.set(colour));
  }

  setBackground(colour: string): void {
    this.material.uniforms.background.value.set(colour);
  }

  /** To be called after places or colours have changed. */
  refresh(): void {
    this.instanceMatrix.needsUpdate = true;
    if (this.instanceColor) this.instanceColor.needsUpdate = true;
  }

  override dispose(): this {
    this.geometry.dispose();
    this.material.dispose();
    super.dispose();
    return this;
  }
}

const vertexShader = /* glsl */ `
  varying vec3 viewNormal;
  varying vec3 colour;
  varying float height;

  void main() {
    vec4 here = instanceMatrix * vec4(position, 1.0);
    mat3 turn = mat3(instanceMatrix);
    vec3 scale2 = vec3(dot(turn[0], turn[0]), dot(turn[1], turn[1]), dot(turn[2], turn[2]));
    viewNormal = normalMatrix * (turn * (normal / scale2));
    colour = instanceColor;
    height = here.y;
    gl_Position = projectionMatrix * (viewMatrix * here);
  }
`;

const fragmentShader = /* glsl */ `
  ${softLight}
  uniform vec3 background;
  varying vec3 viewNormal;
  varying vec3 colour;
  varying float height;

  void main() {
    bool hidden = height * cameraPosition.y < 0.0;
    vec3 lit = softLight(normalize(viewNormal)) * colour;
    gl_FragColor = vec4(hidden ? mix(lit, background, ${veil.toFixed(2)}) : lit, 1.0);
    #include <colorspace_fragment>
  }
`;
