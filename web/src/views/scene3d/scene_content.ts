import { quantile } from './exaggeration.ts';
import { GlobalView } from './global_view.ts';
import type { Ink } from './ink.ts';
import { LegendScales } from './legend_scales.ts';
import { LocalView } from './local_view.ts';
import { NetTables } from './net_tables.ts';
import type { Stage, StagedFrame } from './stages.ts';
import { strokesFor } from './strokes.ts';
import type { Scene3DLegend, Scene3DModel, Scene3DOptions } from './types.ts';

/** Everything allocated for one scene. */
export class SceneContent {
  readonly views: { local: LocalView; global: GlobalView };
  /** Metres: the median rest length. */
  readonly typicalRestLength: number;
  /** #V×3, metres. */
  readonly V: Float64Array;
  private readonly tables: NetTables;
  private readonly scales: LegendScales;
  /** What the tables hold. */
  private shown: { stage: Stage; legend: Scene3DLegend } | null = null;

  constructor(ink: Ink, model: Scene3DModel, onTexture: () => void) {
    this.tables = new NetTables(model.E);
    this.views = {
      local: new LocalView(ink, model, this.tables),
      global: new GlobalView(ink, model, this.tables, onTexture),
    };
    this.scales = new LegendScales(model);
    this.typicalRestLength = quantile(model.r.length, (e) => model.r[e], 0.5);
    this.V = model.V;
  }

  /** Makes both views ready to be drawn; writes and sends tables only when what they hold has changed. */
  refresh({ frame, stage }: StagedFrame, options: Scene3DOptions, pixelsPerMetre: number): Scene3DLegend {
    const { local, global } = this.views;
    const { palette, showSprings, showSurface, selected, pointedAt, lit } = options;
    const strokes = strokesFor(this.typicalRestLength * pixelsPerMetre);
    const legend = this.scales.choose(stage, options, pixelsPerMetre);
    if (stage !== this.shown?.stage || legend !== this.shown.legend) {
      this.tables.setPins(frame);
      local.update(stage, legend);
      global.update(stage, legend.globalExaggeration);
      this.shown = { stage, legend };
    }
    local.setStyle(palette, strokes, lit.localSprings);
    const { globalSprings: litSprings, vertices: litVertices } = lit;
    global.setStyle(palette, strokes, { showSprings, showSurface, litSprings, litVertices });
    for (const { overlay } of [local, global]) overlay.show(frame.pinned.length, selected, pointedAt);
    return legend;
  }

  dispose(): void {
    this.views.local.dispose();
    this.views.global.dispose();
    this.tables.dispose();
  }
}
