import { Color } from 'three';
import type { Glsl } from './glsl.ts';
import { type Ink, InkQuads, type Layer, setInkColour } from './ink.ts';

/** Lengths in CSS pixels; what is not given is not there. */
export interface SegmentStyle {
  width: number;
  /** "#rrggbb", where segments have no colours of their own. */
  colour?: string;
  /** Radius of a dot at either end. */
  dot?: number;
  /** Length of an arrow head at the end, or at the start. */
  head?: number;
  backwards?: boolean;
  /** Whether line and dots keep within the ends, so that a short gap between two segments is not closed by their thickness. */
  within?: boolean;
  /** Length of dashes and of the gaps between them. */
  dash?: number;
  /** A segment that appears shorter than this is not drawn. */
  shortest?: number;
  halo?: number;
  haloColour?: string;
  /** How much of what lies behind it is covered, 0 … 1; all unless given. */
  presence?: number;
}

/** Line segments of a width in pixels, whole or dashed, with round ends, dots or arrow heads. */
export class Segments extends InkQuads {
  private readonly uniforms;

  /** `ends`: see segment_ends.ts. `colours` defines `vec3 colourOf(int segment)`, sRGB. */
  constructor(ink: Ink, layer: Layer, capacity: number, ends: Glsl, colours: Glsl = oneColour) {
    const uniforms = {
      width: { value: 1 },
      colour: { value: new Color() },
      dotRadius: { value: 0 },
      head: { value: 0 },
      backwards: { value: false },
      inset: { value: 0 },
      dash: { value: 0 },
      shortest: { value: 0 },
      presence: { value: 1 },
      halo: { value: 0 },
      haloColour: { value: new Color() },
    };
    const all = { ...uniforms, ...ends.uniforms, ...colours.uniforms };
    super(ink, layer, capacity, all, ends.code + colours.code + vertexMain, fragmentMain);
    this.uniforms = uniforms;
  }

  setStyle(style: SegmentStyle): void {
    const {
      width,
      colour,
      dot = 0,
      head = 0,
      backwards = false,
      within = false,
      dash = 0,
      shortest = 0,
      halo = 0,
      haloColour,
      presence = 1,
    } = style;
    this.uniforms.width.value = width;
    this.uniforms.dotRadius.value = dot;
    this.uniforms.head.value = head;
    this.uniforms.backwards.value = backwards;
    this.uniforms.inset.value = within ? Math.max(dot, width / 2) : 0;
    this.uniforms.dash.value = dash;
    this.uniforms.shortest.value = shortest;
    this.uniforms.halo.value = halo;
    this.uniforms.presence.value = presence;
    if (colour) setInkColour(this.uniforms.colour.value, colour);
    if (haloColour) setInkColour(this.uniforms.haloColour.value, haloColour);
  }
}

const oneColour: Glsl = {
  uniforms: {},
  code: /* glsl */ `
    uniform vec3 colour;
    vec3 colourOf(int segment) { return colour; }
  `,
};

const vertexMain = /* glsl */ `
  uniform float width;
  uniform float dotRadius;
  uniform float head;
  uniform bool backwards;
  uniform float shortest;
  varying vec2 point;
  varying float extent;
  varying vec3 strokeColour;

  void main() {
    vec3 start, end;
    if (backwards) ends(shapeIndex(), end, start);
    else ends(shapeIndex(), start, end);
    vec3 a = (modelViewMatrix * vec4(start, 1.0)).xyz;
    vec3 b = (modelViewMatrix * vec4(end, 1.0)).xyz;
    float near = nearPlane();
    if (a.z > -near && b.z > -near) { hide(); return; }
    if (a.z > -near) a = mix(b, a, (b.z + near) / (b.z - a.z));
    if (b.z > -near) b = mix(a, b, (a.z + near) / (a.z - b.z));

    vec2 from = toPixels(a);
    vec2 to = toPixels(b);
    extent = distance(from, to);
    vec2 direction = extent > 0.0 ? (to - from) / extent : vec2(1.0, 0.0);
    if (extent < shortest * pixelRatio) { hide(); return; }
    float margin = (max(max(0.5 * width, dotRadius), 0.5 * head) + halo) * pixelRatio + 1.0;
    bool atStart = corner().x < 0.0;
    point = vec2(atStart ? -margin : extent + margin, corner().y * margin);
    strokeColour = colourOf(shapeIndex());
    place(from + point.x * direction + point.y * vec2(-direction.y, direction.x), atStart ? a : b, 0.0);
  }
`;

const fragmentMain = /* glsl */ `
  uniform float width;
  uniform float dotRadius;
  uniform float head;
  uniform float inset;
  uniform float dash;
  varying vec2 point;
  varying float extent;
  varying vec3 strokeColour;

  float arrowHead(float headLength) {
    float halfWidth = 0.42 * headLength;
    float side = dot(vec2(point.x - extent, abs(point.y)), normalize(vec2(halfWidth, headLength)));
    return max(side, extent - headLength - point.x);
  }

  void main() {
    float headLength = min(head * pixelRatio, extent);
    float from = min(inset * pixelRatio, 0.5 * extent);
    float to = extent - max(headLength, from);
    float shape = length(vec2(point.x - clamp(point.x, from, to), point.y)) - 0.5 * width * pixelRatio;
    float dashLength = dash * pixelRatio;
    if (dash > 0.0) shape = max(shape, abs(mod(point.x, 2.0 * dashLength) - 0.5 * dashLength) - 0.5 * dashLength);
    float dots = min(length(point - vec2(from, 0.0)), length(point - vec2(to, 0.0))) - dotRadius * pixelRatio;
    if (dotRadius > 0.0) shape = min(shape, dots);
    if (head > 0.0) shape = min(shape, arrowHead(headLength));
    paint(shape, strokeColour);
  }
`;
