import type { Vector3 } from 'three';
import { quantile } from './exaggeration.ts';
import { GlobalView } from './global_view.ts';
import type { Ink } from './ink.ts';
import { LegendScales } from './legend_scales.ts';
import { LocalView } from './local_view.ts';
import type { Palette } from './palette.ts';
import type { Stage, StagedFrame } from './stages.ts';
import { strokesFor } from './strokes.ts';
import type { Hit, Scene3DLegend, Scene3DModel, Scene3DOptions } from './types.ts';

/** Everything allocated for one scene. */
export class SceneContent {
  readonly views: { local: LocalView; global: GlobalView };
  /** Metres: the median rest length. */
  readonly typicalRestLength: number;
  /** #V×3, metres. */
  readonly V: Float64Array;
  private readonly scales: LegendScales;
  /** What the large buffers hold. */
  private shown: [Stage, Palette, boolean, boolean, Scene3DLegend] | null = null;

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
    const strokes = strokesFor(this.typicalRestLength * pixelsPerMetre);
    const legend = this.scales.choose(stage, options, pixelsPerMetre);
    const wanted: NonNullable<typeof this.shown> = [stage, palette, showSprings, showSurface, legend];
    if (!wanted.every((part, at) => part === this.shown?.[at])) {
      local.update(frame.d, stage, palette, legend);
      global.update(stage, palette, legend.globalExaggeration, { springs: showSprings, surface: showSurface });
      this.shown = wanted;
    }
    const selected = { spring: selectedSpring, vertex: selectedVertex };
    const pointedAt = {
      spring: hovered?.kind === 'spring' ? hovered.index : null,
      vertex: hovered?.kind === 'vertex' ? hovered.index : null,
    };
    for (const view of [local, global]) {
      view.setStyle(palette, strokes);
      view.overlay.update(frame, view.segments.data, local.segments.data, view.points, selected, pointedAt);
    }
    global.lightFrom(eye);
    return legend;
  }

  dispose(): void {
    this.views.local.dispose();
    this.views.global.dispose();
  }
}
