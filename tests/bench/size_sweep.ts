import type { SolverModule } from '../../web/src/solver/module.ts';
import { sceneFromRule } from '../support/scene_from_rule.ts';
import { cloth } from './cloth.ts';
import { pairedRounds, type SceneTimes } from './paired_rounds.ts';
import { exponent } from './statistics.ts';

export interface SizeSweep {
  sheets: SceneTimes[];
  /** α where the figure grows as #V^α. */
  exponents: Record<string, number>;
}

/** Cloth of about 1, 3, 10 and 30 thousand vertices. */
const rows = [22, 39, 71, 122];

export async function sizeSweep(solver: SolverModule): Promise<SizeSweep> {
  const sheets: SceneTimes[] = [];
  for (const count of rows) sheets.push(pairedRounds(solver, await sceneFromRule(cloth(count))));
  const growth = (figure: (sheet: SceneTimes) => number) =>
    exponent(
      sheets.map(({ vertices }) => vertices),
      sheets.map(figure),
    );
  return {
    sheets,
    exponents: {
      'nnz(L)': growth(({ nonzeros }) => nonzeros),
      'iteration, native': growth(({ iteration }) => iteration.native),
      'iteration, plain': growth(({ iteration }) => iteration.plain),
      'iteration, fast': growth(({ iteration }) => iteration.fast),
      'precompute, fast': growth(({ precompute }) => precompute.fast),
    },
  };
}
