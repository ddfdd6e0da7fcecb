import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { grouped } from '../../../../lib/grouped.ts';
import { useSceneInspection } from '../../figures/use_scene_inspection.ts';
import { movesByInsertion, tripletsOfQ } from './assembly.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** What it takes to build the flag's Q entry by entry. */
export function InsertionExperiment() {
  const words = inLanguage({ en, zh }).insertion;
  const flag = useSceneInspection('flag');
  if (!flag) return <p>{words.counting}</p>;
  const triplets = tripletsOfQ(flag.scene, flag.scene.pinned, { ...flag.scene, mass_scale: 1 });
  const orders = { written: triplets, backwards: [...triplets].reverse() };
  return (
    <table class="numbers">
      <caption>{fillTemplate(words.caption, { triplets: grouped(triplets.length) })}</caption>
      <tbody>
        {(['written', 'backwards'] as const).map((order) => (
          <tr key={order} data-order={order}>
            <th scope="row">{words[order]}</th>
            <td>{grouped(movesByInsertion(flag.scene.m.length, orders[order]))}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
