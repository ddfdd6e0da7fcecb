import { useState } from 'preact/hooks';
import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { noScene } from '../../../../scene/scene.ts';
import { PatternPlot } from '../../figures/pattern_plot.tsx';
import { useSceneInspection } from '../../figures/use_scene_inspection.ts';
import { en } from './en.ts';
import { factorPattern, minimumDegreeOrder, naturalOrder, patternOf, transposed } from './fill_in.ts';
import { zh } from './zh.ts';

const orders = { natural: naturalOrder, minimumDegree: minimumDegreeOrder } as const;
type Order = keyof typeof orders;

/** Q of the net and its factor, in one order of elimination or another. */
export function FillFigure() {
  const words = inLanguage({ en, zh }).fill;
  const [order, setOrder] = useState<Order>('natural');
  const net = useSceneInspection('net');
  const { m, E } = net ? net.scene : noScene;
  const n = m.length;
  const pattern = patternOf(n, E);
  const { kept, filled } = factorPattern(pattern, orders[order](pattern));
  const diagonal = pattern.map((_, i): [number, number] => [i, i]);
  const counts = { all: n * n, Q: n + 2 * kept.length, L: n + kept.length + filled.length, filled: filled.length };
  return (
    <figure class="figure fill-in" data-ready={net !== null} data-filled={filled.length}>
      <fieldset class="choices">
        <legend>{words.order}</legend>
        {(Object.keys(orders) as Order[]).map((choice) => (
          <label key={choice}>
            <input type="radio" name="elimination-order" checked={choice === order} onChange={() => setOrder(choice)} />
            {words[choice]}
          </label>
        ))}
      </fieldset>
      <div class="pattern-plots">
        <PatternPlot
          n={n}
          layers={[{ kind: 'entry', places: [...diagonal, ...kept, ...transposed(kept)] }]}
          label={fillTemplate(words.Q, counts)}
        />
        <PatternPlot
          n={n}
          layers={[
            { kind: 'entry', places: [...diagonal, ...kept] },
            { kind: 'fill', places: filled },
          ]}
          label={fillTemplate(words.L, counts)}
        />
      </div>
      <figcaption>{words.caption}</figcaption>
    </figure>
  );
}
