import {
  Color,
  DoubleSide,
  Float32BufferAttribute,
  InstancedBufferGeometry,
  type IUniform,
  LinearSRGBColorSpace,
  Mesh,
  ShaderMaterial,
  Vector2,
} from 'three';

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
  colour.setStyle(hex, LinearSRGBColorSpace);
}

/** Drawn under everything, among everything by depth, or over everything. */
export type Layer = 'beneath' | 'among' | 'above';
const renderOrders: Record<Layer, number> = { beneath: -1, among: 0, above: 1 };

/**
 * Flat shapes of a size in pixels, one quad an instance: `vertexMain` calls `place`, `fragmentMain` calls `paint`.
 * Everything is opaque, smoothed by alpha-to-coverage, so that no sorting is needed.
 */
export function createInkMesh(
  ink: Ink,
  uniforms: Record<string, IUniform>,
  vertexMain: string,
  fragmentMain: string,
  layer: Layer,
): Mesh<InstancedBufferGeometry, ShaderMaterial> {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  const material = new ShaderMaterial({
    uniforms: { ...ink, ...uniforms },
    vertexShader: inkVertexShader + vertexMain,
    fragmentShader: inkFragmentShader + fragmentMain,
    side: DoubleSide,
    alphaToCoverage: true,
    depthTest: layer === 'among',
    depthWrite: layer === 'among',
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = renderOrders[layer];
  return mesh;
}

/** Quads are placed with w = 1, so that varyings run straight in screen space. */
const inkVertexShader = /* glsl */ `
  uniform vec2 viewport;
  uniform float pixelRatio;
  uniform float fadeFrom;
  uniform float fadeTo;
  uniform float haloDepth;
  uniform float halo;
  varying float fade;
  varying float haloPush;

  vec2 toPixels(vec3 viewPosition) {
    vec4 clip = projectionMatrix * vec4(viewPosition, 1.0);
    return clip.xy / clip.w * 0.5 * viewport;
  }

  void place(vec2 pixels, vec3 viewPosition, float lift) {
    vec4 clip = projectionMatrix * vec4(viewPosition + vec3(0.0, 0.0, lift), 1.0);
    vec4 pushed = projectionMatrix * vec4(viewPosition - vec3(0.0, 0.0, haloDepth), 1.0);
    haloPush = 0.5 * (pushed.z / pushed.w - clip.z / clip.w);
    fade = 0.6 * smoothstep(fadeFrom, fadeTo, -viewPosition.z);
    gl_Position = vec4(pixels / (0.5 * viewport), clip.z / clip.w, 1.0);
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
