import type { Selection } from '../../app/state.ts';
import type { Pull } from '../../solver/protocol.ts';
import type { Canvas3D } from './canvas3d.ts';
import { quantile } from './exaggeration.ts';
import { GlobalView } from './global_view.ts';
import { NetTables } from './net_tables.ts';
import type { Palette } from './palette.ts';
import { type PokeOptions, Poking } from './poking.ts';
import { PullMarks } from './pull_marks.ts';
import { stageOf } from './stages.ts';
import { strokesFor } from './strokes.ts';
import type { Scene3DModel } from './types.ts';

/** Where the nets are; nobody changes the arrays. */
export interface NetsFrame {
  /** #V×3 each, metres: one for every view. */
  nets: readonly Float64Array[];
  /** #pinned, and #pinned×3, metres. */
  pinned: Int32Array;
  targets: Float64Array;
}

export interface NetsOptions {
  showSprings: boolean;
  showSurface: boolean;
  /** Null: only pins can be dragged. */
  poke: PokeOptions | null;
  pull: Pull | null;
  palette: Palette;
}

const nothing: Selection = { spring: null, vertex: null };

/** Everything allocated for one scene. */
export class NetsContent {
  readonly views: readonly GlobalView[];
  /** Metres: the median rest length. */
  readonly typicalRestLength: number;
  /** #V×3, metres. */
  readonly V: Float64Array;
  readonly poking: Poking;
  private readonly tables: NetTables;
  private readonly pullMarks: readonly PullMarks[];
  private tinted: Int32Array = new Int32Array();
  private shown: NetsFrame | null = null;

  constructor({ ink }: Canvas3D, model: Scene3DModel, count: number, onTexture: () => void) {
    this.V = model.V;
    this.tables = new NetTables(model.E);
    this.views = Array.from({ length: count }, () => new GlobalView(ink, model, this.tables, onTexture));
    this.poking = new Poking(model);
    this.pullMarks = this.views.map(({ scene }) => {
      const marks = new PullMarks(ink, model.V.length / 3);
      scene.add(marks.group);
      return marks;
    });
    this.typicalRestLength = quantile(model.r.length, (e) => model.r[e], 0.5);
  }

  refresh(frame: NetsFrame, options: NetsOptions, marked: Int32Array, pixelsPerMetre: number): void {
    const { palette, pull, showSprings, showSurface } = options;
    const touched = pull?.vertices ?? marked;
    const strokes = strokesFor(this.typicalRestLength * pixelsPerMetre);
    const { pinned, targets } = frame;
    if (frame !== this.shown) this.tables.setPins(frame);
    this.views.forEach((view, net) => {
      const p = frame.nets[net];
      const still = { phase: 'accept', p, pBefore: p, d: null, prediction: p, pinned, targets } as const;
      if (frame !== this.shown) view.update(stageOf(still, 1), null);
      view.setStyle(palette, strokes, { showSprings, showSurface, litSprings: false, litVertices: false });
      view.overlay.show(pinned.length, nothing, nothing);
      if (touched !== this.tinted) view.tint(touched);
      this.pullMarks[net].setStyle(palette, strokes);
      this.pullMarks[net].show(touched, pull, view.points, pixelsPerMetre);
    });
    this.shown = frame;
    this.tinted = touched;
  }

  dispose(): void {
    for (const part of [...this.views, ...this.pullMarks]) part.dispose();
    this.tables.dispose();
  }
}
