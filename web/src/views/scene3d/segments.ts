import { Color } from 'three';
import { packColour, parseColour } from './colour.ts';
import { type Ink, InkQuads, type Layer, setInkColour } from './ink.ts';
import { segmentStride } from './spring_segments.ts';

/** Lengths in CSS pixels; what is not given is not there. */
export interface SegmentStyle {
  width: number;
  /** Radius of a dot at either end. */
  dot?: number;
  /** Length of an arrow head at the end. */
  head?: number;
  /** How far a zigzag swings aside of a straight line. */
  swing?: number;
  halo?: number;
  haloColour?: string;
  /** How much of what lies behind it is covered, 0 … 1; all unless given. */
  presence?: number;
}

/** Line segments of a width in pixels with round ends, dots or arrow heads. */
export class Segments extends InkQuads {
  private readonly uniforms;

  constructor(ink: Ink, capacity: number, layer: Layer) {
    const uniforms = {
      width: { value: 1 },
      dotRadius: { value: 0 },
      head: { value: 0 },
      swing: { value: 0 },
      presence: { value: 1 },
      halo: { value: 0 },
      haloColour: { value: new Color() },
    };
    super(ink, layer, capacity, segmentStride / 4, uniforms, vertexMain, fragmentMain);
    this.uniforms = uniforms;
  }

  setStyle({ width, dot = 0, head = 0, swing = 0, halo = 0, haloColour, presence = 1 }: SegmentStyle): void {
    this.uniforms.width.value = width;
    this.uniforms.dotRadius.value = dot;
    this.uniforms.head.value = head;
    this.uniforms.swing.value = swing;
    this.uniforms.halo.value = halo;
    this.uniforms.presence.value = presence;
    if (haloColour) setInkColour(this.uniforms.haloColour.value, haloColour);
  }

  /** One colour for all of them. */
  fill(hex: string): void {
    const colour = packColour(parseColour(hex));
    for (let at = 3; at < this.data.length; at += segmentStride) this.data[at] = colour;
  }
}

const vertexMain = /* glsl */ `
  uniform float width;
  uniform float dotRadius;
  uniform float head;
  uniform float swing;
  varying vec2 point;
  varying float extent;
  varying vec3 strokeColour;

  void main() {
    vec4 start = texel(0);
    vec3 a = (modelViewMatrix * vec4(start.xyz, 1.0)).xyz;
    vec3 b = (modelViewMatrix * vec4(texel(1).xyz, 1.0)).xyz;
    float near = nearPlane();
    if (a.z > -near && b.z > -near) { hide(); return; }
    if (a.z > -near) a = mix(b, a, (b.z + near) / (b.z - a.z));
    if (b.z > -near) b = mix(a, b, (a.z + near) / (a.z - b.z));

    vec2 from = toPixels(a);
    vec2 to = toPixels(b);
    extent = distance(from, to);
    vec2 direction = extent > 0.0 ? (to - from) / extent : vec2(1.0, 0.0);
    if (head > 0.0 && extent < 2.0 * pixelRatio) { hide(); return; }
    float margin = (max(max(0.5 * width + swing, dotRadius), 0.5 * head) + halo) * pixelRatio + 1.0;
    bool atStart = corner().x < 0.0;
    point = vec2(atStart ? -margin : extent + margin, corner().y * margin);
    int packed = int(start.w);
    strokeColour = vec3(packed >> 16, packed >> 8 & 255, packed & 255) / 255.0;
    place(from + point.x * direction + point.y * vec2(-direction.y, direction.x), atStart ? a : b, 0.0);
  }
`;

const fragmentMain = /* glsl */ `
  uniform float width;
  uniform float dotRadius;
  uniform float head;
  uniform float swing;
  varying vec2 point;
  varying float extent;
  varying vec3 strokeColour;

  const float bends = 8.0;

  vec2 zigzagNode(float index) {
    float at = clamp((index - 0.5) / bends, 0.0, 1.0);
    bool bent = index > 0.0 && index < bends + 1.0;
    float side = mod(index, 2.0) < 0.5 ? 1.0 : -1.0;
    float aside = min(swing * pixelRatio, 0.12 * extent); // seen from its end, a spring is not a scribble
    return vec2(mix(0.16, 0.84, at) * extent, bent ? side * aside : 0.0);
  }

  float toSegment(vec2 a, vec2 b) {
    vec2 ab = b - a;
    return length(point - a - clamp(dot(point - a, ab) / dot(ab, ab), 0.0, 1.0) * ab);
  }

  float zigzag() {
    float index = clamp(floor((point.x / extent - 0.16) / 0.68 * bends + 0.5), 0.0, bends);
    float nearest = min(toSegment(vec2(0.0), zigzagNode(0.0)), toSegment(zigzagNode(bends + 1.0), vec2(extent, 0.0)));
    for (float step = -1.0; step <= 1.0; step++) {
      float from = clamp(index + step, 0.0, bends);
      nearest = min(nearest, toSegment(zigzagNode(from), zigzagNode(from + 1.0)));
    }
    return nearest;
  }

  float arrowHead(float headLength) {
    float halfWidth = 0.42 * headLength;
    float side = dot(vec2(point.x - extent, abs(point.y)), normalize(vec2(halfWidth, headLength)));
    return max(side, extent - headLength - point.x);
  }

  void main() {
    float headLength = min(head * pixelRatio, extent);
    float shaft = extent - headLength;
    float line = swing > 0.0 ? zigzag() : length(vec2(point.x - clamp(point.x, 0.0, shaft), point.y));
    float shape = line - 0.5 * width * pixelRatio;
    float dots = min(length(point), length(point - vec2(extent, 0.0))) - dotRadius * pixelRatio;
    if (dotRadius > 0.0) shape = min(shape, dots);
    if (head > 0.0) shape = min(shape, arrowHead(headLength));
    paint(shape, strokeColour);
  }
`;
