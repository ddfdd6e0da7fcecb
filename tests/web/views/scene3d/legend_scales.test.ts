import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { LegendScales, type ScaleOptions } from '../../../../web/src/views/scene3d/legend_scales.ts';
import { pieceLength } from '../../../../web/src/views/scene3d/spring_pieces.ts';
import type { Stage } from '../../../../web/src/views/scene3d/stages.ts';

const V = Float64Array.of(0, 0, 0, 1, 0, 0);
const model = { V, E: Int32Array.of(0, 1), F: new Uint32Array(), texture: null, r: Float64Array.of(1) };
const automatic: ScaleOptions = { exaggeration: 'automatic', strainRange: 'automatic' };

/** The spring stretched by `strain`, and moved by `moved` metres; null when it is whole, or does not move. */
function stageWith(strain: number, moved: number | null, d: Float64Array | null = Float64Array.of(1, 0, 0)): Stage {
  const torn = Float64Array.of(0, 0, 0, 1 + strain, 0, 0);
  const ghost = moved === null ? null : Float64Array.from(torn, (c, at) => (at % 3 === 1 ? c - moved : c));
  return { torn, d, tear: 1, from: torn, to: torn, move: 1, ghost, reveal: 1, towardsGhost: false };
}

const scalesOf = (stage: Stage, pixelsPerMetre = 100) =>
  new LegendScales(model).choose(stage, automatic, pixelsPerMetre);

describe('the gap', () => {
  it('that can be seen is true: ×1 from six pixels on', () => {
    // 0.06 m at 100 pixels a metre.
    expect(scalesOf(stageWith(0.061, null)).localExaggeration).toBe(1);
    expect(scalesOf(stageWith(-0.061, null)).localExaggeration).toBe(1);
  });

  it('is otherwise drawn from 4.8 to 12 pixels wide, where the spring has them', () => {
    for (const gap of [0.0011, 0.003, 0.01, 0.05]) {
      const factor = scalesOf(stageWith(gap, null)).localExaggeration as number;
      expect(100 * gap * factor).toBeLessThanOrEqual(12);
      expect(100 * gap * factor).toBeGreaterThanOrEqual(4.8);
    }
  });

  it('leaves nineteen of twenty springs at least three fifths of their length, or their true rest length', () => {
    const strains = fc.array(fc.double({ min: -0.5, max: 1, noNaN: true }), { minLength: 20, maxLength: 200 });
    fc.assert(
      fc.property(strains, fc.double({ min: 1, max: 1000, noNaN: true }), (all, pixelsPerMetre) => {
        const net = Float64Array.from(all.flatMap((strain, e) => [0, e, 0, 1 + strain, e, 0]));
        const E = Int32Array.from({ length: 2 * all.length }, (_, at) => at);
        const r = new Float64Array(all.length).fill(1);
        const scales = new LegendScales({ ...model, V: net, E, r });
        const stage = { ...stageWith(0, null), torn: net, to: net, from: net };
        const factor = scales.choose(stage, automatic, pixelsPerMetre).localExaggeration as number;
        const short = all.filter((strain) => {
          const length = pieceLength(1 + strain, 1, factor);
          return length < Math.min(1, 0.6 * (1 + strain) * (1 - 1e-12)); // roundings of the quotient that gave the factor
        });
        expect(short.length).toBeLessThanOrEqual(all.length / 20);
      }),
    );
  });
});

describe('LegendScales', () => {
  it('makes the typical arrow at least sixteen pixels long', () => {
    // 2 mm at 100 pixels a metre are 0.2 pixels.
    expect(scalesOf(stageWith(0, 0.002)).globalExaggeration).toBe(100);
    expect(scalesOf(stageWith(0, 0.0015)).globalExaggeration).toBe(200);
  });

  it('gives the strongest strain full colour', () => {
    expect(scalesOf(stageWith(-0.021, null)).strainRange).toBe(0.02);
  });

  it('a scene at rest gets finite numbers', () => {
    expect(scalesOf(stageWith(0, 0))).toEqual({
      localExaggeration: 1000,
      globalExaggeration: 1000,
      strainRange: 1e-4,
    });
  });

  it('says that nothing is exaggerated while nothing is torn, or nothing moves', () => {
    expect(scalesOf(stageWith(0.1, 0.1, null)).localExaggeration).toBeNull();
    expect(scalesOf(stageWith(0.1, null)).globalExaggeration).toBeNull();
  });

  it('what is not automatic is what was asked for', () => {
    const asked = { ...automatic, exaggeration: 7, strainRange: 0.03 };
    const legend = new LegendScales(model).choose(stageWith(0.5, 0.5), asked, 100);
    expect(legend).toEqual({ localExaggeration: 7, globalExaggeration: 7, strainRange: 0.03 });
    const still = new LegendScales(model).choose(stageWith(0.5, null, null), asked, 100);
    expect(still).toEqual({ localExaggeration: null, globalExaggeration: null, strainRange: 0.03 });
  });

  it('is the same object while its numbers stay, so that nothing is drawn anew', () => {
    const scales = new LegendScales(model);
    const legend = scales.choose(stageWith(0.004, 0.002), automatic, 100);
    expect(scales.choose(stageWith(0.0042, 0.0021), automatic, 110)).toBe(legend);
    expect(scales.choose(stageWith(0.05, 0.002), automatic, 100)).not.toBe(legend);
  });

  it('remembers the exaggeration of movement while nothing moves', () => {
    const scales = new LegendScales(model);
    scales.choose(stageWith(0, 0.001), automatic, 100);
    scales.choose(stageWith(0, null), automatic, 100);
    // Alone, this movement would get ×100.
    expect(scales.choose(stageWith(0, 0.002), automatic, 100).globalExaggeration).toBe(200);
  });
});
