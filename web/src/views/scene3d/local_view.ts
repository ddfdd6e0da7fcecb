import { Scene } from 'three';
import type { Ink } from './ink.ts';
import { Overlay } from './overlay.ts';
import type { Palette } from './palette.ts';
import { type SegmentStyle, Segments } from './segments.ts';
import { pieceSegments, segmentStride, springSegments, springStrain } from './spring_segments.ts';
import type { Stage } from './stages.ts';
import { StrainColourTable } from './strain_colour.ts';
import type { Strokes } from './strokes.ts';
import type { Scene3DLegend, Scene3DModel } from './types.ts';

/** The net torn into springs, each alone at its projection, over the ghost of the net. */
export class LocalView {
  readonly scene = new Scene();
  readonly segments: Segments;
  readonly overlay: Overlay;
  /** #V×3, metres: the net that is torn. */
  points: Float64Array;
  private readonly model: Scene3DModel;
  private readonly ghost: Segments;
  private torn = false;
  private colours: StrainColourTable | null = null;

  constructor(ink: Ink, model: Scene3DModel) {
    this.model = model;
    this.points = model.V;
    this.segments = new Segments(ink, model.r.length, 'net');
    this.ghost = new Segments(ink, model.r.length, 'ghost');
    this.overlay = new Overlay(ink, model.V.length / 3);
    this.scene.add(this.ghost.mesh, this.segments.mesh, this.overlay.group);
  }

  setStyle(palette: Palette, strokes: Strokes): void {
    const whole: SegmentStyle = { width: strokes.spring };
    const piece = this.torn ? { ...whole, dot: strokes.pieceDot, within: true } : whole;
    this.ghost.setStyle({ width: strokes.pieceGhost });
    this.segments.setStyle({ ...piece, halo: strokes.halo, haloColour: palette.background });
    this.overlay.setStyle(palette, strokes, piece);
  }

  update({ torn, d, tear }: Stage, palette: Palette, strokes: Strokes, legend: Scene3DLegend): void {
    const { E, r } = this.model;
    const { data } = this.segments;
    const { localExaggeration, strainRange } = legend;
    this.points = torn;
    this.torn = d !== null;
    this.ghost.mesh.visible = this.torn && strokes.pieceGhost > 0;
    if (this.ghost.mesh.visible) {
      springSegments(torn, E, this.ghost.data);
      this.ghost.fill(palette.ghost);
      this.ghost.commit();
    }
    if (d === null || localExaggeration === null) springSegments(torn, E, data);
    else pieceSegments(torn, E, r, d, localExaggeration, tear, data);
    if (this.colours?.scale !== palette.strain) this.colours = new StrainColourTable(palette.strain);
    for (let e = 0; e < r.length; e++) {
      data[segmentStride * e + 3] = this.colours.colour(springStrain(torn, E, r, e), strainRange);
    }
    this.segments.commit();
  }

  dispose(): void {
    for (const part of [this.ghost, this.segments, this.overlay]) part.dispose();
  }
}
