import { Scene } from 'three';
import type { Ink } from './ink.ts';
import { Overlay } from './overlay.ts';
import type { Palette } from './palette.ts';
import { Segments } from './segments.ts';
import { pieceSegments, segmentStride, springSegments, springStrain } from './spring_segments.ts';
import type { Stage } from './stages.ts';
import { StrainColourTable } from './strain_colour.ts';
import type { Strokes } from './strokes.ts';
import type { Scene3DFrame, Scene3DLegend, Scene3DModel } from './types.ts';

/** The net torn into springs, each alone at its projection, over the ghost of the net. */
export class LocalView {
  readonly scene = new Scene();
  readonly segments: Segments;
  readonly overlay: Overlay;
  /** #V×3, metres: the net that is torn. */
  points: Float64Array;
  private readonly model: Scene3DModel;
  private readonly ghost: Segments;

  constructor(ink: Ink, model: Scene3DModel) {
    this.model = model;
    this.points = model.V;
    this.segments = new Segments(ink, model.r.length, 'among');
    this.ghost = new Segments(ink, model.r.length, 'beneath');
    this.overlay = new Overlay(ink, model.V.length / 3);
    this.scene.add(this.ghost.mesh, this.segments.mesh, this.overlay.group);
  }

  setStyle(palette: Palette, strokes: Strokes): void {
    const piece = { width: strokes.piece, dot: strokes.pieceDot, swing: strokes.pieceSwing };
    this.ghost.mesh.visible = strokes.pieceGhost > 0;
    this.ghost.setStyle({ width: strokes.pieceGhost });
    this.segments.setStyle({ ...piece, halo: strokes.halo, haloColour: palette.background });
    this.overlay.setStyle(palette, strokes, piece);
  }

  update(d: Scene3DFrame['d'], stage: Stage, palette: Palette, legend: Scene3DLegend): void {
    const { E, r } = this.model;
    this.points = stage.torn;
    springSegments(stage.torn, E, this.ghost.data);
    this.ghost.fill(palette.ghost);
    this.ghost.commit();

    const { data } = this.segments;
    if (d) pieceSegments(stage.torn, E, r, d, legend.localExaggeration, stage.tear, data);
    else springSegments(stage.torn, E, data);
    const colours = new StrainColourTable(palette.strain);
    for (let e = 0; e < r.length; e++) {
      data[segmentStride * e + 3] = colours.colour(springStrain(stage.torn, E, r, e), legend.strainRange);
    }
    this.segments.commit();
  }

  dispose(): void {
    for (const part of [this.ghost, this.segments, this.overlay]) part.dispose();
  }
}
