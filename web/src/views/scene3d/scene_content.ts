import type { Vector3 } from 'three';
import { quantile } from './exaggeration.ts';
import { GlobalView } from './global_view.ts';
import type { Ink } from './ink.ts';
import { LegendScales } from './legend_scales.ts';
import { LocalView } from './local_view.ts';
import type { Palette } from './palette.ts';
import type { Stage, StagedFrame } from './stages.ts';
import { type Strokes, strokesFor } from './strokes.ts';
import type { Hit, Scene3DLegend, Scene3DModel, Scene3DOptions } from './types.ts';

/** Everything allocated for one scene. */
export class SceneContent {
  readonly views: { local: LocalView; global: GlobalView };
  /** Metres: the median rest length. */
  readonly typicalRestLength: number;
  /** #V×3, metres. */
  readonly V: Float64Array;
  private readonly scales: LegendScales;
  private strokes = strokesFor(0);
  private springPixels = 0;
  /** What the large buffers hold. */
  private shown: [Stage, Palette, Strokes, boolean, boolean, Scene3DLegend] | null = null;

  constructor(ink: Ink, model: Scene3DModel, onTexture: () => void) {
    this.views = { local: new LocalView(ink, model), global: new GlobalView(ink, model, onTexture) };
    this.scales = new LegendScales(model);
    this.typicalRestLength = quantile(model.r.length, (e) => model.r[e], 0.5);
    this.V = model.V;
  }

  /** Makes both views ready to be drawn; writes the large buffers only when what they hold has changed. */
  refresh(
    { frame, stage }: StagedFrame,
    options: Scene3DOptions,
    pixelsPerMetre: number,
    hovered: Hit | null,
    eye: Vector3,
  ): Scene3DLegend {
    const { local, global } = this.views;
    const { palette, showSprings, showSurface, selectedSpring, selectedVertex } = options;
    const strokes = this.strokesAt(this.typicalRestLength * pixelsPerMetre);
    const legend = this.scales.choose(stage, options, pixelsPerMetre);
    const wanted: NonNullable<typeof this.shown> = [stage, palette, strokes, showSprings, showSurface, legend];
    if (!wanted.every((part, at) => part === this.shown?.[at])) {
      local.update(stage, palette, strokes, legend);
      const visible = { springs: showSprings, surface: showSurface };
      global.update(stage, palette, strokes, legend.globalExaggeration, visible);
      this.shown = wanted;
    }
    const selected = { spring: selectedSpring, vertex: selectedVertex };
    const pointedAt = {
      spring: hovered?.kind === 'spring' ? hovered.index : null,
      vertex: hovered?.kind === 'vertex' ? hovered.index : null,
    };
    for (const view of [local, global]) {
      view.setStyle(palette, strokes);
      view.overlay.update(frame, view.segments.data, view.points, selected, pointedAt);
    }
    global.lightFrom(eye);
    return legend;
  }

  /** The same object as before while the camera keeps its distance. */
  private strokesAt(springPixels: number): Strokes {
    if (springPixels !== this.springPixels) this.strokes = strokesFor(springPixels);
    this.springPixels = springPixels;
    return this.strokes;
  }

  dispose(): void {
    this.views.local.dispose();
    this.views.global.dispose();
  }
}
