import type { Camera, Selection } from '../../app/state.ts';
import type { Rectangle } from '../../lib/rectangle.ts';
import type { Scene } from '../../scene/scene.ts';
import type { Frame } from '../../solver/frame.ts';
import type { Pull } from '../../solver/protocol.ts';
import type { Palette } from './palette.ts';

export type ViewName = 'local' | 'global';

/** What stays the same while a scene is simulated. Allocates every buffer once. */
export interface Scene3DModel extends Pick<Scene, 'V' | 'E' | 'F' | 'texture'> {
  /** #E, metres: rest lengths. */
  r: Float64Array;
}

/** What is drawn of a frame; nobody changes its arrays. At global and accept, d was computed from pBefore. */
export type Scene3DFrame = Pick<Frame, 'phase' | 'p' | 'pBefore' | 'd' | 'prediction' | 'pinned' | 'targets'>;

export interface Scene3DOptions {
  /** Dimensionless factor on what a half-step moves, in both views; automatic makes it about ten pixels. */
  exaggeration: number | 'automatic';
  /** What the global view draws; springs anyway when the scene has no triangles. */
  showSprings: boolean;
  showSurface: boolean;
  selected: Selection;
  /** Under the pointer, here or wherever else on the page the same is shown. */
  pointedAt: Selection;
  /** Marked as a whole, since a symbol is pointed at that stands for all of them. */
  lit: { localSprings: boolean; globalSprings: boolean; vertices: boolean };
  palette: Palette;
  /** |strain| (dimensionless) drawn in full colour. */
  strainRange: number | 'automatic';
}

/** What "automatic" came to: the legend says it. */
export interface Scene3DLegend {
  /** Factor on the gaps of the local view; null while no spring is torn (at predict). */
  localExaggeration: number | null;
  /** Factor on what the global view's arrows and ghost show; null while nothing moves (at local and accept). */
  globalExaggeration: number | null;
  strainRange: number;
}

export interface Hit {
  kind: 'vertex' | 'spring';
  index: number;
  /** On the canvas; of a long spring only what is near the pointer. */
  bounds: Rectangle;
}

/** What a canvas with views tells. */
export interface CanvasCallbacks {
  /** Something changed that only `render()` will show: call it in the next animation frame. */
  onInvalidate(): void;
  /** What a mouse rests on has changed. */
  onHover(hit: Hit | null): void;
  /** A click or tap; null on empty space. */
  onSelect(hit: Hit | null): void;
  /** A click with shift on a vertex. */
  onPinToggle(vertex: number): void;
  onDragStart(vertex: number): void;
  /** `target`: #3, metres. */
  onDrag(vertex: number, target: Float64Array): void;
  onDragEnd(vertex: number): void;
  /** The vertices that a press would take hold of, or has, where nets can be poked. */
  onMark?(vertices: Int32Array | null): void;
  /** Null when the pull ends. */
  onPull?(pull: Pull | null): void;
  onCameraChange(camera: Camera): void;
  onContextLost(): void;
}

export interface Scene3DCallbacks extends CanvasCallbacks {
  onLegend(legend: Scene3DLegend): void;
}

export interface ScreenPoint {
  x: number;
  y: number;
}
