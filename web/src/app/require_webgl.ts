import { Obstacle } from './obstacle.ts';

/** Throws the reason, for the reader, where pictures cannot be drawn. */
export function requireWebGL(): void {
  if (!document.createElement('canvas').getContext('webgl2')) throw new Obstacle('page.errors.noWebGL');
}
