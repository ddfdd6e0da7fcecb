import { describe, expect, it } from 'vitest';
import { LegendScales } from '../../../../web/src/views/scene3d/legend_scales.ts';
import { lightPalette } from '../../../../web/src/views/scene3d/palette.ts';
import type { Stage } from '../../../../web/src/views/scene3d/stages.ts';
import type { Scene3DOptions } from '../../../../web/src/views/scene3d/types.ts';

const V = Float64Array.of(0, 0, 0, 1, 0, 0);
const model = { V, E: Int32Array.of(0, 1), F: new Uint32Array(), texture: null, r: Float64Array.of(1) };
const automatic: Scene3DOptions = {
  exaggeration: 'automatic',
  strainRange: 'automatic',
  showSprings: true,
  showSurface: true,
  selectedSpring: null,
  selectedVertex: null,
  palette: lightPalette,
};

/** The spring stretched by `strain`, and moved by `moved` metres. */
function stageWith(strain: number, moved: number | null): Stage {
  const torn = Float64Array.of(0, 0, 0, 1 + strain, 0, 0);
  const ghost = moved === null ? null : Float64Array.from(torn, (c, at) => (at % 3 === 1 ? c - moved : c));
  return { torn, tear: 1, from: torn, to: torn, move: 1, ghost, reveal: 1, towardsGhost: false };
}

describe('LegendScales', () => {
  it('makes the gap of a typical spring about two fifths of it', () => {
    const { localExaggeration } = new LegendScales(model).choose(stageWith(0.004, null), automatic, 100);
    expect(localExaggeration).toBe(100);
  });

  it('makes arrows about twenty pixels long', () => {
    // 2 mm at 100 pixels a metre are 0.2 pixels.
    const { globalExaggeration } = new LegendScales(model).choose(stageWith(0, 0.002), automatic, 100);
    expect(globalExaggeration).toBe(100);
  });

  it('gives the strongest strain about the full colour', () => {
    expect(new LegendScales(model).choose(stageWith(-0.021, null), automatic, 100).strainRange).toBe(0.02);
  });

  it('a scene at rest gets finite numbers', () => {
    const legend = new LegendScales(model).choose(stageWith(0, 0), automatic, 100);
    expect(legend).toEqual({ localExaggeration: 1000, globalExaggeration: 1000, strainRange: 1e-4 });
  });

  it('what is not automatic is what was asked for', () => {
    const asked = { ...automatic, exaggeration: 7, strainRange: 0.03 };
    const legend = new LegendScales(model).choose(stageWith(0.5, 0.5), asked, 100);
    expect(legend).toEqual({ localExaggeration: 7, globalExaggeration: 7, strainRange: 0.03 });
  });

  it('is the same object while its numbers stay, so that nothing is drawn anew', () => {
    const scales = new LegendScales(model);
    const legend = scales.choose(stageWith(0.004, 0.002), automatic, 100);
    expect(scales.choose(stageWith(0.005, 0.0025), automatic, 110)).toBe(legend);
    expect(scales.choose(stageWith(0.05, 0.002), automatic, 100)).not.toBe(legend);
  });

  it('keeps the exaggeration of movement while nothing moves', () => {
    const scales = new LegendScales(model);
    scales.choose(stageWith(0, 0.002), automatic, 100);
    expect(scales.choose(stageWith(0, null), automatic, 100).globalExaggeration).toBe(100);
  });
});
