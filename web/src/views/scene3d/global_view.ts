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
const mostArrows = 400;
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
    this.segments = new Segments(ink, model.r.length, 'among');
    this.vertices = new Marks(ink, vertexCount, 'disc', 'among');
    this.ghost = new Segments(ink, model.r.length, 'beneath');
    this.arrows = new Segments(ink, this.arrowVertices.length, 'above');
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
    this.vertices.mesh.visible = strokes.vertex > 0 && this.segments.mesh.visible;
    this.arrows.setStyle({ width: strokes.arrow, head: strokes.arrowHead, halo: 1, haloColour: background });
    this.overlay.setStyle(palette, strokes, spring);
  }

  /** Soft light that goes with the eye, so that no side of the cloth is ever black. */
  lightFrom(eye: Vector3): void {
    this.light.position.copy(eye);
    this.light.position.y += 0.5 * eye.length();
  }

  update(stage: Stage, palette: Palette, exaggeration: number, shown: { springs: boolean; surface: boolean }): void {
    const { E } = this.model;
    interpolatePoints(stage.from, stage.to, stage.move, this.points);
    springSegments(this.points, E, this.segments.data);
    this.segments.fill(palette.spring);
    this.segments.commit();
    this.vertices.moveTo(this.points);

    this.ghost.mesh.visible = stage.ghost !== null;
    this.arrows.mesh.visible = stage.ghost !== null;
    if (stage.ghost) {
      for (let c = 0; c < this.points.length; c++) {
        this.ghostPoints[c] = this.points[c] + stage.reveal * exaggeration * (stage.ghost[c] - stage.to[c]);
      }
      springSegments(this.ghostPoints, E, this.ghost.data);
      this.ghost.fill(palette.ghost);
      this.ghost.commit();
      const [tails, tips] = stage.towardsGhost ? [this.points, this.ghostPoints] : [this.ghostPoints, this.points];
      arrowSegments(this.arrowVertices, tails, tips, this.arrows.data);
      this.arrows.fill(palette.arrow);
      this.arrows.commit();
    }

    const cloth = shown.surface ? this.surface : null;
    if (this.surface) this.surface.mesh.visible = cloth !== null;
    this.segments.mesh.visible = shown.springs || cloth === null;
    if (cloth) {
      cloth.colour = palette.cloth;
      cloth.update(this.points);
    }
  }

  dispose(): void {
    for (const part of [this.ghost, this.segments, this.vertices, this.arrows, this.overlay]) part.dispose();
    this.surface?.dispose();
  }
}
