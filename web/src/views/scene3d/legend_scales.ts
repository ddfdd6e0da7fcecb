import { exaggerations } from '../../app/limits.ts';
import { displacement } from './displacements.ts';
import { quantile, settleAbove, settleBelow, strainRanges } from './exaggeration.ts';
import { springLength, strain } from './spring_pieces.ts';
import type { Stage } from './stages.ts';
import type { Scene3DLegend, Scene3DModel, Scene3DOptions } from './types.ts';

/** What automatic exaggeration aims at. A typical gap of half of this is not exaggerated: no step lies between ×1 and ×2. */
const gapPixels = 12;
/** The most that the gap may take of a strongly strained spring's length. */
const gapShare = 0.4;
/** The typical arrow's least length. */
const arrowPixels = 16;

const typically = 0.8;
const strongly = 0.95;

export type ScaleOptions = Pick<Scene3DOptions, 'exaggeration' | 'strainRange'>;

/** Chooses the automatic scales, and remembers them so that they change seldom. */
export class LegendScales {
  private readonly model: Scene3DModel;
  private gapFactor: number | undefined;
  private moveFactor: number | undefined;
  private strainRange: number | undefined;
  private chosen: Scene3DLegend | null = null;

  constructor(model: Scene3DModel) {
    this.model = model;
  }

  /** The same object as before when no number changes. */
  choose(stage: Stage, { exaggeration, strainRange }: ScaleOptions, pixelsPerMetre: number): Scene3DLegend {
    const manual = exaggeration === 'automatic' ? null : exaggeration;
    const wanted: Scene3DLegend = {
      localExaggeration: stage.d && (manual ?? this.chooseGapFactor(stage.torn, pixelsPerMetre)),
      globalExaggeration: stage.ghost && (manual ?? this.chooseMoveFactor(stage.ghost, stage.to, pixelsPerMetre)),
      strainRange: strainRange === 'automatic' ? this.chooseStrainRange(stage.torn) : strainRange,
    };
    if (!this.chosen || !sameLegend(this.chosen, wanted)) this.chosen = wanted;
    return this.chosen;
  }

  private chooseGapFactor(torn: Float64Array, pixelsPerMetre: number): number {
    const { E, r } = this.model;
    const gap = (e: number) => Math.abs(springLength(torn, E, e) - r[e]);
    const share = (e: number) => {
      const l = springLength(torn, E, e);
      return l === r[e] ? 0 : Math.abs(l - r[e]) / l;
    };
    const typical = quantile(r.length, gap, typically) * pixelsPerMetre;
    const strong = quantile(r.length, share, strongly);
    this.gapFactor = settleBelow(Math.min(gapPixels / typical, gapShare / strong), this.gapFactor, exaggerations);
    return this.gapFactor;
  }

  private chooseMoveFactor(ghost: Float64Array, to: Float64Array, pixelsPerMetre: number): number {
    const typical = quantile(to.length / 3, (v) => displacement(ghost, to, v), typically) * pixelsPerMetre;
    this.moveFactor = settleAbove(arrowPixels / typical, this.moveFactor, exaggerations);
    return this.moveFactor;
  }

  /** What is strained most has full colour. */
  private chooseStrainRange(torn: Float64Array): number {
    const { E, r } = this.model;
    const strong = quantile(r.length, (e) => Math.abs(strain(springLength(torn, E, e), r[e])), strongly);
    this.strainRange = settleBelow(strong, this.strainRange, strainRanges);
    return this.strainRange;
  }
}

function sameLegend(a: Scene3DLegend, b: Scene3DLegend): boolean {
  return (
    a.localExaggeration === b.localExaggeration &&
    a.globalExaggeration === b.globalExaggeration &&
    a.strainRange === b.strainRange
  );
}
