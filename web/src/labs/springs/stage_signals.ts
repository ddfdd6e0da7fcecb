import { signal } from '@preact/signals';
import type { Scene3D } from '../../views/scene3d/scene3d.ts';
import type { Scene3DLegend } from '../../views/scene3d/types.ts';

/** The 3D view while it is mounted: for what needs to know where things are on the screen. */
export const scene3D = signal<Scene3D | null>(null);

/** Where the canvas begins, CSS pixels from the stage's corner. */
export const canvasOrigin = signal({ x: 0, y: 0 });

/** Counts the pictures drawn: HTML that stands on the picture moves with it. */
export const pictures = signal(0);

/** What "automatic" came to, for the words in the views. */
export const legend = signal<Scene3DLegend>({ localExaggeration: 1, globalExaggeration: 1, strainRange: 0.1 });
