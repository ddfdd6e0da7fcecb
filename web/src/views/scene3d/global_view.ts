import { Scene } from 'three';
import { interpolatePoints, thinned } from './displacements.ts';
import type { Ink } from './ink.ts';
import { Marks } from './marks.ts';
import type { NetTables } from './net_tables.ts';
import { Overlay } from './overlay.ts';
import type { Palette } from './palette.ts';
import { joining } from './segment_ends.ts';
import { Segments } from './segments.ts';
import { springEnds } from './spring_pieces.ts';
import type { Stage } from './stages.ts';
import { haloFor, type Strokes } from './strokes.ts';
import { Surface } from './surface.ts';
import { encloses } from './surface_geometry.ts';
import { Table } from './table.ts';
import type { Scene3DModel } from './types.ts';

/** More arrows than this are a thicket. */
const mostArrows = 160;
/** Springs over a cloth show its mesh and leave its picture. */
const presenceOnCloth = 0.4;
/** CSS pixels: of vertices that crowd too much to be drawn otherwise. */
const leastLitRadius = 1.5;

/** What the reader wants to see, and what is marked as a whole. */
interface Shown {
  showSprings: boolean;
  showSurface: boolean;
  litSprings: boolean;
  litVertices: boolean;
}

/** The net that the linear solve stitched together, and what moved. */
export class GlobalView {
  readonly scene = new Scene();
  readonly overlay: Overlay;
  /** #V×3, metres: the vertices as drawn. */
  readonly points: Float64Array;
  private readonly E: Int32Array;
  private readonly pointTable = new Table(3);
  private readonly segments: Segments;
  private readonly vertices: Marks;
  /** #V×3, metres: where vertices were or will be, exaggerated. */
  private readonly ghostPoints: Float64Array;
  private readonly ghostTable = new Table(3);
  private readonly ghost: Segments;
  /** #arrows×2: a vertex, twice. */
  private readonly arrowTable = new Table(2);
  private readonly arrows: Segments;
  /** Whether arrows come from the ghost, a place left behind, rather than point to it, a prediction. */
  private leftGhost = false;
  private readonly surface: Surface | null;
  /** Whether the surface has an inside, which it hides. */
  private readonly solid: boolean;

  constructor(ink: Ink, model: Scene3DModel, tables: NetTables, onTexture: () => void) {
    const { pointTable, ghostTable, arrowTable } = this;
    const vertexCount = model.V.length / 3;
    const springCount = model.r.length;
    const ends = joining(tables.springs, pointTable, pointTable);
    const moved = thinned(model.V, mostArrows);
    arrowTable.set([...moved].flatMap((vertex) => [vertex, vertex]));
    this.E = model.E;
    this.points = model.V.slice();
    this.ghostPoints = model.V.slice();
    this.segments = new Segments(ink, 'net', springCount, ends);
    this.vertices = new Marks(ink, 'net', vertexCount, 'disc', pointTable);
    this.ghost = new Segments(ink, 'ghost', springCount, joining(tables.springs, ghostTable, ghostTable));
    this.arrows = new Segments(ink, 'arrow', moved.length, joining(arrowTable, pointTable, ghostTable));
    this.surface = model.F.length > 0 ? new Surface(model, pointTable, onTexture) : null;
    this.solid = encloses(model.F);
    this.overlay = new Overlay(ink, vertexCount, tables, pointTable, ends);
    this.scene.add(this.ghost.mesh, this.segments.mesh, this.vertices.mesh, this.arrows.mesh, this.overlay.group);
    if (this.surface) this.scene.add(this.surface.mesh);
  }

  setStyle(palette: Palette, strokes: Strokes, { showSprings, showSurface, litSprings, litVertices }: Shown): void {
    const { background, glow } = palette;
    const clothShown = this.surface !== null && showSurface;
    const spring = { width: strokes.spring, colour: palette.spring };
    if (this.surface) this.surface.mesh.visible = clothShown;
    const pale = clothShown && !litSprings;
    this.segments.mesh.visible = showSprings || litSprings || !clothShown;
    this.vertices.mesh.visible = litVertices || (this.segments.mesh.visible && strokes.vertex > 0);
    this.ghost.setStyle({ width: strokes.ghost, colour: palette.ghost });
    this.segments.setStyle({
      ...spring,
      ...(pale ? { presence: presenceOnCloth } : haloFor(litSprings, palette, strokes)),
    });
    this.vertices.setStyle({
      radius: litVertices ? Math.max(strokes.vertex, leastLitRadius) : strokes.vertex,
      halo: litVertices ? strokes.glow : 0,
      colour: palette.vertex,
      haloColour: glow,
    });
    this.arrows.setStyle({
      width: strokes.arrow,
      colour: palette.arrow,
      head: strokes.arrowHead,
      backwards: this.leftGhost,
      shortest: 2,
      halo: 1,
      haloColour: background,
    });
    this.overlay.setStyle(palette, strokes, spring);
    this.overlay.hidePinsBehind(clothShown && this.solid);
    this.surface?.setColours(palette.cloth, palette.pull);
  }

  update(stage: Stage, exaggeration: number | null): void {
    interpolatePoints(stage.from, stage.to, stage.move, this.points);
    this.pointTable.set(this.points);
    this.updateMoves(stage, exaggeration);
  }

  /** Ghost and arrows: each vertex's way from or to where it was or will be, `exaggeration` times as long. */
  private updateMoves({ ghost, to, reveal, towardsGhost }: Stage, exaggeration: number | null): void {
    const { points, ghostPoints } = this;
    const moves = ghost !== null && exaggeration !== null;
    this.ghost.mesh.visible = moves;
    this.arrows.mesh.visible = moves;
    if (!moves) return;
    for (let c = 0; c < points.length; c++) ghostPoints[c] = points[c] + reveal * exaggeration * (ghost[c] - to[c]);
    this.ghostTable.set(ghostPoints);
    this.leftGhost = !towardsGhost;
  }

  /** The surface around these vertices, if there is one. */
  tint(vertices: Int32Array): void {
    this.surface?.setTinted(vertices);
  }

  /** #E×6, metres: where the springs are drawn. */
  springEnds(): Float32Array {
    return springEnds(this.points, this.E);
  }

  dispose(): void {
    for (const part of [this.ghost, this.segments, this.vertices, this.arrows, this.overlay]) part.dispose();
    for (const table of [this.pointTable, this.ghostTable, this.arrowTable]) table.dispose();
    this.surface?.dispose();
  }
}
