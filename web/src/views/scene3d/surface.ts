import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Mesh,
  ShaderMaterial,
  SRGBColorSpace,
  type Texture,
  TextureLoader,
} from 'three';
import { softLight } from './soft_light.ts';
import { surfaceCorners, trianglesAround } from './surface_geometry.ts';
import { readTable, Table } from './table.ts';
import type { Scene3DModel } from './types.ts';

/** The cloth: both sides, soft light. Its shader takes places from the table of points and finds the normals there, too. */
export class Surface {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly fans = new Table(2);
  private readonly others = new Table(2);
  /** #V×2: 1 in the first column where the surface is tinted. */
  private readonly tints = new Table(2);
  private readonly vertexCount: number;
  private readonly uniforms;

  /** `points`: #V×3, metres. */
  constructor(model: Scene3DModel, points: Table, onTexture: () => void) {
    const { vertices, uvs, triangles } = surfaceCorners(model.F, model.texture);
    const { fans, others } = trianglesAround(model.F, model.V.length / 3);
    this.vertexCount = model.V.length / 3;
    this.fans.set(fans);
    this.others.set(others);
    this.setTinted([]);
    const geometry = new BufferGeometry();
    geometry.setAttribute('vertex', new BufferAttribute(Float32Array.from(vertices), 1));
    geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
    geometry.setIndex(new BufferAttribute(triangles, 1));
    this.uniforms = {
      points: points.uniform,
      fans: this.fans.uniform,
      others: this.others.uniform,
      tints: this.tints.uniform,
      tintColour: { value: new Color() },
      picture: { value: null as Texture | null },
      pictured: { value: false },
      colour: { value: new Color() },
    };
    const material = new ShaderMaterial({
      uniforms: this.uniforms,
      vertexShader,
      fragmentShader,
      side: DoubleSide,
      polygonOffset: true, // lets springs in the cloth lie on it
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 4,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    if (model.texture) this.loadTexture(model.texture.url, onTexture);
  }

  /** "#rrggbb" each: of the cloth while the texture is missing or still on its way, and of what is tinted. */
  setColours(cloth: string, tint: string): void {
    this.uniforms.colour.value.setHex(Number.parseInt(cloth.slice(1), 16));
    this.uniforms.tintColour.value.setHex(Number.parseInt(tint.slice(1), 16));
  }

  /** Around these vertices. */
  setTinted(vertices: ArrayLike<number>): void {
    const rows = this.tints.write(this.vertexCount);
    rows.fill(0);
    for (let at = 0; at < vertices.length; at++) rows[2 * vertices[at]] = 1;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.uniforms.picture.value?.dispose();
    this.fans.dispose();
    this.others.dispose();
    this.tints.dispose();
  }

  private loadTexture(url: string, onTexture: () => void): void {
    new TextureLoader().load(url, (texture) => {
      texture.colorSpace = SRGBColorSpace;
      texture.anisotropy = 8; // keeps a slanted weave from blurring
      this.uniforms.picture.value = texture;
      this.uniforms.pictured.value = true;
      onTexture();
    });
  }
}

const vertexShader = /* glsl */ `
  ${readTable}
  uniform sampler2D points;
  uniform sampler2D fans;
  uniform sampler2D others;
  uniform sampler2D tints;
  attribute float vertex;
  varying vec3 viewNormal;
  varying vec2 place;
  varying float tint;

  vec3 pointOf(int v) { return row(points, v).xyz; }

  /** The sum of the adjacent triangles' normals, each weighted by its area. */
  vec3 normalOf(int v) {
    vec3 here = pointOf(v);
    vec2 fan = row(fans, v).xy;
    vec3 sum = vec3(0.0);
    for (int at = int(fan.x); at < int(fan.y); at++) {
      vec2 pair = row(others, at).xy;
      sum += cross(pointOf(int(pair.x)) - here, pointOf(int(pair.y)) - here);
    }
    return sum;
  }

  void main() {
    viewNormal = normalize(normalMatrix * normalOf(int(vertex)));
    place = uv;
    tint = row(tints, int(vertex)).x;
    gl_Position = projectionMatrix * (modelViewMatrix * vec4(pointOf(int(vertex)), 1.0));
  }
`;

const fragmentShader = /* glsl */ `
  ${softLight}
  uniform sampler2D picture;
  uniform bool pictured;
  uniform vec3 colour;
  uniform vec3 tintColour;
  varying vec3 viewNormal;
  varying vec2 place;
  varying float tint;

  void main() {
    vec3 normal = normalize(gl_FrontFacing ? viewNormal : -viewNormal);
    vec3 cloth = pictured ? texture2D(picture, place).rgb : colour;
    gl_FragColor = vec4(softLight(normal) * mix(cloth, tintColour, 0.5 * tint), 1.0);
    #include <colorspace_fragment>
  }
`;
