import { DirectionalLight, HemisphereLight, Scene, type Vector3 } from 'three';
import { arrowSegments, interpolatePoints, thinned } from './displacements.ts';
import type { Ink } from './ink.ts';
import { Marks } from './marks.ts';
import { Overlay } from './overlay.ts';
import type { Palette } from './palette.ts';
import { Segments } from './segments.ts';
import { springSegments } from './spring_segments.ts';
import type { Stage } from './stages.ts';
import type { Strokes } from './strokes.ts';
import { Surface } from './surface.ts';
import type { Scene3DModel } from './types.ts';

/** More arrows than this are a thicket. */
const mostArrows = 160;
/** Springs over a cloth show its mesh and leave its picture. */
const presenceOnCloth = 0.4;

/** The net that the linear solve stitched together, and what moved. */
export class GlobalView {
  readonly scene = new Scene();
  readonly segments: Segments;
  readonly overlay: Overlay;
  /** #V×3, metres: the vertices as drawn. */
  readonly points: Float64Array;
  private readonly model: Scene3DModel;
  private readonly vertices: Marks;
  private readonly ghost: Segments;
  private readonly ghostPoints: Float64Array;
  private readonly arrows: Segments;
  private readonly arrowVertices: Int32Array;
  private readonly surface: Surface | null;
  private readonly light = new DirectionalLight('#ffffff', 1.9);

  constructor(ink: Ink, model: Scene3DModel, onTexture: () => void) {
    this.model = model;
    const vertexCount = model.V.length / 3;
    this.points = model.V.slice();
    this.ghostPoints = model.V.slice();
    this.arrowVertices = thinned(model.V, mostArrows);
    this.segments = new Segments(ink, model.r.length, 'net');
    this.vertices = new Marks(ink, vertexCount, 'disc', 'net');
    this.ghost = new Segments(ink, model.r.length, 'ghost');
    this.arrows = new Segments(ink, this.arrowVertices.length, 'arrow');
    this.surface = model.F.length > 0 ? new Surface(model, onTexture) : null;
    this.overlay = new Overlay(ink, vertexCount);
    this.scene.add(new HemisphereLight('#ffffff', '#c4c8d0', 1.7), this.light, this.light.target);
    this.scene.add(this.ghost.mesh, this.segments.mesh, this.vertices.mesh, this.arrows.mesh, this.overlay.group);
    if (this.surface) this.scene.add(this.surface.mesh);
  }

  setStyle(palette: Palette, strokes: Strokes): void {
    const { background } = palette;
    const spring = { width: strokes.spring };
    this.ghost.setStyle({ width: strokes.ghost });
    this.segments.setStyle(
      this.surface?.mesh.visible
        ? { ...spring, presence: presenceOnCloth }
        : { ...spring, halo: strokes.halo, haloColour: background },
    );
    this.vertices.setStyle({ radius: strokes.vertex, halo: 0, colour: palette.vertex, haloColour: background });
    this.arrows.setStyle({
      width: strokes.arrow,
      head: strokes.arrowHead,
      shortest: 2,
      halo: 1,
      haloColour: background,
    });
    this.overlay.setStyle(palette, strokes, spring);
  }

  /** Soft light that goes with the eye, so that no side of the cloth is ever black. */
  lightFrom(eye: Vector3): void {
    this.light.position.copy(eye);
    this.light.position.y += 0.5 * eye.length();
  }

  update(
    stage: Stage,
    palette: Palette,
    strokes: Strokes,
    exaggeration: number | null,
    shown: { springs: boolean; surface: boolean },
  ): void {
    interpolatePoints(stage.from, stage.to, stage.move, this.points);
    const showSurface = this.surface !== null && shown.surface;
    this.updateSprings(palette, strokes, shown.springs || !showSurface);
    this.updateMoves(stage, palette, exaggeration);
    if (!this.surface) return;
    this.surface.mesh.visible = showSurface;
    if (showSurface) this.surface.update(this.points, palette.cloth);
  }

  private updateSprings(palette: Palette, strokes: Strokes, visible: boolean): void {
    this.segments.mesh.visible = visible;
    this.vertices.mesh.visible = visible && strokes.vertex > 0;
    springSegments(this.points, this.model.E, this.segments.data);
    this.segments.fill(palette.spring);
    this.segments.commit();
    this.vertices.moveTo(this.points);
  }

  /** Ghost and arrows: each vertex's way from or to where it was or will be, `exaggeration` times as long. */
  private updateMoves({ ghost, to, reveal, towardsGhost }: Stage, palette: Palette, exaggeration: number | null): void {
    const { points, ghostPoints } = this;
    const moves = ghost !== null && exaggeration !== null;
    this.ghost.mesh.visible = moves;
    this.arrows.mesh.visible = moves;
    if (!moves) return;
    for (let c = 0; c < points.length; c++) ghostPoints[c] = points[c] + reveal * exaggeration * (ghost[c] - to[c]);
    springSegments(ghostPoints, this.model.E, this.ghost.data);
    this.ghost.fill(palette.ghost);
    this.ghost.commit();
    const [tails, tips] = towardsGhost ? [points, ghostPoints] : [ghostPoints, points];
    arrowSegments(this.arrowVertices, tails, tips, this.arrows.data);
    this.arrows.fill(palette.arrow);
    this.arrows.commit();
  }

  dispose(): void {
    for (const part of [this.ghost, this.segments, this.vertices, this.arrows, this.overlay]) part.dispose();
    this.surface?.dispose();
  }
}
