import { Scene } from 'three';
import type { Ink } from './ink.ts';
import type { NetTables } from './net_tables.ts';
import { Overlay } from './overlay.ts';
import type { Palette } from './palette.ts';
import { joining, torn } from './segment_ends.ts';
import { type SegmentStyle, Segments } from './segments.ts';
import { pieceEnds, writePieces } from './spring_pieces.ts';
import type { Stage } from './stages.ts';
import { StrainShader } from './strain_shader.ts';
import { haloFor, type Strokes } from './strokes.ts';
import { Table } from './table.ts';
import type { Scene3DLegend, Scene3DModel } from './types.ts';

/** The net torn into springs, each alone at its projection, over the ghost of the net. */
export class LocalView {
  readonly scene = new Scene();
  readonly overlay: Overlay;
  /** #V×3, metres: the net that is torn. */
  points: Float64Array;
  private readonly model: Scene3DModel;
  private readonly pointTable = new Table(3);
  private readonly pieceTable = new Table(4);
  /** #E×4, as `writePieces` describes them. */
  private pieces: Float32Array = new Float32Array();
  private readonly strainShader = new StrainShader();
  private readonly segments: Segments;
  private readonly ghost: Segments;
  private torn = false;

  constructor(ink: Ink, model: Scene3DModel, tables: NetTables) {
    const { pointTable, pieceTable } = this;
    const springCount = model.r.length;
    const ends = torn(tables.springs, pointTable, pieceTable);
    this.model = model;
    this.points = model.V;
    this.segments = new Segments(ink, 'net', springCount, ends, this.strainShader);
    this.ghost = new Segments(ink, 'ghost', springCount, joining(tables.springs, pointTable, pointTable));
    this.overlay = new Overlay(ink, model.V.length / 3, tables, pointTable, ends);
    this.scene.add(this.ghost.mesh, this.segments.mesh, this.overlay.group);
  }

  setStyle(palette: Palette, strokes: Strokes, lit: boolean): void {
    const whole: SegmentStyle = { width: strokes.spring };
    const piece = this.torn ? { ...whole, dot: strokes.pieceDot, within: true } : whole;
    this.ghost.mesh.visible = this.torn && strokes.pieceGhost > 0;
    this.ghost.setStyle({ width: strokes.pieceGhost, colour: palette.ghost });
    this.segments.setStyle({ ...piece, ...haloFor(lit, palette, strokes) });
    this.strainShader.setScale(palette.strain);
    this.overlay.setStyle(palette, strokes, piece);
  }

  update({ torn, d, tear }: Stage, { localExaggeration, strainRange }: Scene3DLegend): void {
    const { E, r } = this.model;
    this.points = torn;
    this.torn = d !== null;
    this.pointTable.set(torn);
    this.pieces = this.pieceTable.write(r.length);
    const projected = d && localExaggeration ? { d, exaggeration: localExaggeration, tear } : null;
    writePieces(torn, E, r, projected, strainRange, this.pieces);
  }

  /** #E×6, metres: where the springs are drawn. */
  springEnds(): Float32Array {
    return pieceEnds(this.points, this.model.E, this.pieces);
  }

  dispose(): void {
    for (const part of [this.ghost, this.segments, this.overlay, this.pointTable, this.pieceTable]) part.dispose();
  }
}
