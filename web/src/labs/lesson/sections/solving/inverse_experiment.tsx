import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { PatternPlot } from '../../figures/pattern_plot.tsx';
import { useSceneInspection } from '../../figures/use_scene_inspection.ts';
import { cholesky, inverse } from './cholesky.ts';
import { en } from './en.ts';
import { nonZeros, smallMatrix } from './small_matrix.ts';
import { zh } from './zh.ts';

/** Where Q, L and Q⁻¹ of a net are not zero. */
export function InverseExperiment() {
  const words = inLanguage({ en, zh }).inverse;
  const net = useSceneInspection('net');
  const Q = net && smallMatrix(net.Q);
  const factor = Q && cholesky(Q);
  if (!factor || !('L' in factor)) return null;
  const { L } = factor;
  return (
    <div class="pattern-plots">
      {(
        [
          ['Q', Q],
          ['L', L],
          ['inverse', inverse(L)],
        ] as const
      ).map(([name, matrix]) => {
        const places = nonZeros(matrix);
        const label = fillTemplate(words[name], { count: places.length, all: matrix.length ** 2 });
        return <PatternPlot key={name} n={matrix.length} layers={[{ kind: 'entry', places }]} label={label} />;
      })}
    </div>
  );
}
