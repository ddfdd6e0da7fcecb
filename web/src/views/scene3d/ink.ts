import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  type IUniform,
  LinearSRGBColorSpace,
  Mesh,
  ShaderMaterial,
  Vector2,
} from 'three';
import { readTable } from './table.ts';

/** Uniforms that all strokes and marks share; set before each view is drawn. */
export interface Ink extends Record<string, IUniform> {
  /** Device pixels. */
  viewport: { value: Vector2 };
  /** Device pixels per CSS pixel. */
  pixelRatio: { value: number };
  background: { value: Color };
  /** Metres from the camera between which colours fade towards the background, so that depth reads without shadows. */
  fadeFrom: { value: number };
  fadeTo: { value: number };
  /** Metres by which the halo around a stroke lies behind it: strokes that meet stay joined, those farther behind are parted. */
  haloDepth: { value: number };
}

export function createInk(): Ink {
  return {
    viewport: { value: new Vector2(1, 1) },
    pixelRatio: { value: 1 },
    background: { value: new Color() },
    fadeFrom: { value: 0 },
    fadeTo: { value: 1 },
    haloDepth: { value: 0 },
  };
}

/** The ink shaders write sRGB themselves, so three must keep their colours as they are. */
export function setInkColour(colour: Color, hex: string): void {
  colour.setHex(Number.parseInt(hex.slice(1), 16), LinearSRGBColorSpace);
}

/** Each is drawn over those before it; only what is in the net hides one another by depth. */
const layers = ['ghost', 'net', 'highlight', 'arrow', 'pin'] as const;
export type Layer = (typeof layers)[number];

/**
 * Flat shapes of a size in pixels, one quad each. The quads have no vertex attributes: shaders read from tables what they need, which every
 * graphics card (and a software renderer) draws much faster than as many instances of four vertices.
 * Everything is opaque, smoothed by alpha-to-coverage, so that nothing needs sorting.
 */
export class InkQuads {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly first = { value: 0 };

  /** `vertexMain` draws the shape number `shapeIndex()` and calls `place`, `fragmentMain` calls `paint`. */
  constructor(
    ink: Ink,
    layer: Layer,
    capacity: number,
    uniforms: Record<string, IUniform>,
    vertexMain: string,
    fragmentMain: string,
  ) {
    const geometry = new BufferGeometry();
    geometry.setIndex(new BufferAttribute(quadCorners(capacity), 1));
    const material = new ShaderMaterial({
      uniforms: { ...ink, ...uniforms, first: this.first },
      vertexShader: inkVertexShader + vertexMain,
      fragmentShader: inkFragmentShader + fragmentMain,
      side: DoubleSide,
      alphaToCoverage: true,
      depthTest: layer === 'net',
      depthWrite: layer === 'net',
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = layers.indexOf(layer) - layers.indexOf('net'); // a cloth, too, has 0
  }

  /** Which shapes are drawn: `count` of them, at most the capacity, from number `first` on; all unless told. */
  show(first: number, count: number): void {
    this.first.value = first;
    this.mesh.geometry.setDrawRange(0, 6 * count);
  }

  /** Whether shapes are hidden by what is in front of them, whatever their layer. */
  hideBehind(hidden: boolean): void {
    this.mesh.material.depthTest = hidden;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/** #quads×6: the corners of two triangles each. In plain loops, since there may be a million of them. */
function quadCorners(quads: number): Uint32Array {
  const corners = new Uint32Array(6 * quads);
  let at = 0;
  for (let quad = 0; quad < quads; quad++) {
    for (const corner of [0, 1, 2, 2, 1, 3]) corners[at++] = 4 * quad + corner;
  }
  return corners;
}

/** Quads are placed with w = 1, so that varyings run straight in screen space. */
const inkVertexShader = /* glsl */ `
  ${readTable}
  uniform int first;
  uniform vec2 viewport;
  uniform float pixelRatio;
  uniform float fadeFrom;
  uniform float fadeTo;
  uniform float haloDepth;
  uniform float halo;
  varying float fade;
  varying float haloPush;

  int shapeIndex() { return first + gl_VertexID / 4; }

  /** ±1 along the shape and across it. */
  vec2 corner() { return 2.0 * vec2(gl_VertexID / 2 % 2, gl_VertexID % 2) - 1.0; }

  float nearPlane() { return projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0); }

  void hide() { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }

  // The camera looks straight ahead, so four numbers of its projection are all.
  vec2 toPixels(vec3 viewPosition) {
    vec2 focus = vec2(projectionMatrix[0][0], projectionMatrix[1][1]);
    return focus * viewPosition.xy / -viewPosition.z * 0.5 * viewport;
  }

  float toDepth(float viewZ) { return (projectionMatrix[2][2] * viewZ + projectionMatrix[3][2]) / -viewZ; }

  /** Puts a corner at a place of the view, in pixels from its middle, at the depth of a point lifted towards the eye. */
  void place(vec2 pixels, vec3 viewPosition, float lift) {
    float depth = toDepth(viewPosition.z + lift);
    haloPush = 0.5 * (toDepth(viewPosition.z - haloDepth) - depth);
    fade = 0.6 * smoothstep(fadeFrom, fadeTo, -viewPosition.z);
    gl_Position = vec4(pixels / (0.5 * viewport), depth, 1.0);
  }
`;

/** `paint` fills a shape given its signed distance in device pixels, with a halo around it; what lies behind shows through a `presence` under 1. */
const inkFragmentShader = /* glsl */ `
  uniform float pixelRatio;
  uniform float halo;
  uniform vec3 haloColour;
  uniform float presence;
  uniform vec3 background;
  varying float fade;
  varying float haloPush;

  void paint(float signedDistance, vec3 colour) {
    float haloWidth = halo * pixelRatio;
    float core = clamp(0.5 - signedDistance, 0.0, 1.0);
    float cover = clamp(0.5 + haloWidth - signedDistance, 0.0, 1.0);
    if (cover == 0.0) discard;
    vec3 faded = mix(colour, background, fade);
    gl_FragColor = vec4(halo > 0.0 ? mix(haloColour, faded, core) : faded, cover * presence);
    gl_FragDepth = gl_FragCoord.z + (core < 0.5 ? haloPush : 0.0);
  }
`;
