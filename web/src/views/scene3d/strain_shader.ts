import { Color } from 'three';
import type { Glsl } from './glsl.ts';
import { setInkColour } from './ink.ts';
import type { StrainScale } from './palette.ts';

/** `strainColour`, for the strains in the table of pieces: colours of `torn` segments. */
export class StrainShader implements Glsl {
  readonly uniforms = { scale: { value: Array.from({ length: 5 }, () => new Color()) } };
  readonly code = /* glsl */ `
    uniform vec3 scale[5];

    vec3 colourOf(int segment) {
      float stride = 2.0 + 2.0 * row(pieces, segment).w;
      int below = min(3, int(stride));
      return mix(scale[below], scale[below + 1], stride - float(below));
    }
  `;

  setScale(scale: StrainScale): void {
    scale.forEach((hex, stop) => {
      setInkColour(this.uniforms.scale.value[stop], hex);
    });
  }
}
