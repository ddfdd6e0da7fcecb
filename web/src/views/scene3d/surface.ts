import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Mesh,
  MeshLambertMaterial,
  SRGBColorSpace,
  TextureLoader,
} from 'three';
import { surfaceCorners, takeRows, vertexNormals } from './surface_geometry.ts';
import type { Scene3DModel } from './types.ts';

/** The cloth: both sides, soft light, normals recomputed from the net each frame. */
export class Surface {
  readonly mesh: Mesh<BufferGeometry, MeshLambertMaterial>;
  /** #F×3. */
  private readonly F: Uint32Array;
  private readonly corners: Int32Array;
  /** #corners×3. */
  private readonly positions: BufferAttribute;
  private readonly normals: BufferAttribute;
  /** #V×3. */
  private readonly netNormals: Float32Array;

  constructor(model: Scene3DModel, onTexture: () => void) {
    this.F = model.F;
    const { vertices, uvs, triangles } = surfaceCorners(model.F, model.texture);
    this.corners = vertices;
    this.positions = new BufferAttribute(new Float32Array(3 * vertices.length), 3).setUsage(DynamicDrawUsage);
    this.normals = new BufferAttribute(new Float32Array(3 * vertices.length), 3).setUsage(DynamicDrawUsage);
    this.netNormals = new Float32Array(model.V.length);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.positions);
    geometry.setAttribute('normal', this.normals);
    geometry.setAttribute('uv', new BufferAttribute(uvs, 2));
    geometry.setIndex(new BufferAttribute(triangles, 1));
    this.mesh = new Mesh(
      geometry,
      new MeshLambertMaterial({
        side: DoubleSide,
        polygonOffset: true, // lets springs in the cloth lie on it
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 4,
      }),
    );
    this.mesh.frustumCulled = false;
    if (model.texture) this.loadTexture(model.texture.url, onTexture);
  }

  /** "#rrggbb": while the texture is missing or still on its way. */
  setColour(hex: string): void {
    const { color, map } = this.mesh.material;
    color.setHex(map ? 0xffffff : Number.parseInt(hex.slice(1), 16));
  }

  /** `p`: #V×3, metres. */
  update(p: Float64Array): void {
    vertexNormals(p, this.F, this.netNormals);
    takeRows(p, this.corners, this.positions.array);
    takeRows(this.netNormals, this.corners, this.normals.array);
    this.positions.needsUpdate = true;
    this.normals.needsUpdate = true;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.map?.dispose();
    this.mesh.material.dispose();
  }

  private loadTexture(url: string, onTexture: () => void): void {
    new TextureLoader().load(url, (texture) => {
      texture.colorSpace = SRGBColorSpace;
      texture.anisotropy = 8; // keeps a slanted weave from blurring
      this.mesh.material.map = texture;
      this.mesh.material.needsUpdate = true;
      onTexture();
    });
  }
}
