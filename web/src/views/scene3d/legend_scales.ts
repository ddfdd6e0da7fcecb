import { displacement } from './displacements.ts';
import { exaggerations, quantile, settle, strainRanges } from './exaggeration.ts';
import { springStrain } from './spring_segments.ts';
import type { Stage } from './stages.ts';
import type { Scene3DLegend, Scene3DModel, Scene3DOptions } from './types.ts';

/** What automatic exaggeration aims at: the gap that tears a typical spring from the next, in lengths of the spring, and arrows in CSS pixels. */
const gapShare = 0.4;
const arrowPixels = 20;

/** Chooses the automatic scales, and remembers them so that they change seldom. */
export class LegendScales {
  private readonly model: Scene3DModel;
  private automatic: Scene3DLegend | null = null;
  private chosen: Scene3DLegend | null = null;

  constructor(model: Scene3DModel) {
    this.model = model;
  }

  /** The same object as before when no number changes. */
  choose(stage: Stage, options: Scene3DOptions, pixelsPerMetre: number): Scene3DLegend {
    const { E, r } = this.model;
    const { torn, ghost, to } = stage;
    const before = this.automatic;
    const strainAt = (e: number) => Math.abs(springStrain(torn, E, r, e));
    const typical = quantile(r.length, strainAt, 0.8);
    const strong = quantile(r.length, strainAt, 0.95);
    const moved = ghost ? quantile(to.length / 3, (v) => displacement(ghost, to, v), 0.8) * pixelsPerMetre : 0;
    this.automatic = {
      localExaggeration: settle(gapShare / typical, before?.localExaggeration, exaggerations),
      globalExaggeration: ghost
        ? settle(arrowPixels / moved, before?.globalExaggeration, exaggerations)
        : (before?.globalExaggeration ?? 1),
      strainRange: settle(strong, before?.strainRange, strainRanges),
    };

    const { exaggeration, strainRange } = options;
    const wanted = { ...this.automatic };
    if (exaggeration !== 'automatic') wanted.localExaggeration = wanted.globalExaggeration = exaggeration;
    if (strainRange !== 'automatic') wanted.strainRange = strainRange;
    if (!this.chosen || !sameLegend(this.chosen, wanted)) this.chosen = wanted;
    return this.chosen;
  }
}

function sameLegend(a: Scene3DLegend, b: Scene3DLegend): boolean {
  return (
    a.localExaggeration === b.localExaggeration &&
    a.globalExaggeration === b.globalExaggeration &&
    a.strainRange === b.strainRange
  );
}
