import type { IUniform } from 'three';

/** A piece of a shader, and the uniforms that it declares. */
export interface Glsl {
  uniforms: Record<string, IUniform>;
  code: string;
}
