import { inLanguage } from '../../../../app/messages/in_language.ts';
import { t } from '../../../../app/messages/index.ts';
import { formatQuantity } from '../../../../lib/format.ts';
import { grouped } from '../../../../lib/grouped.ts';
import { useSceneInspection } from '../../figures/use_scene_inspection.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

const scenes = ['square', 'net', 'flag'] as const;

/** How much of the solver's Q is not zero. */
export function EntryCounts() {
  const words = inLanguage({ en, zh }).counts;
  return (
    <table class="numbers entry-counts">
      <caption>{words.caption}</caption>
      <thead>
        <tr>
          <th scope="col">{words.scene}</th>
          <th scope="col">#V</th>
          <th scope="col">#E</th>
          <th scope="col">{words.all}</th>
          <th scope="col">{words.nonZero}</th>
          <th scope="col">{words.share}</th>
        </tr>
      </thead>
      <tbody>
        {scenes.map((name) => (
          <SceneRow key={name} name={name} />
        ))}
      </tbody>
    </table>
  );
}

function SceneRow({ name }: { name: (typeof scenes)[number] }) {
  const inspected = useSceneInspection(name);
  const numbers = inspected && [
    inspected.Q.rows,
    inspected.A.rows,
    inspected.Q.rows ** 2,
    inspected.Q.value.length,
    formatQuantity((100 * inspected.Q.value.length) / inspected.Q.rows ** 2, '%', 2),
  ];
  return (
    <tr data-scene={name}>
      <th scope="row">{t(`page.scenes.${name}`)}</th>
      {(numbers ?? ['…', '…', '…', '…', '…']).map((number, column) => (
        <td key={column}>{typeof number === 'number' ? grouped(number) : number}</td>
      ))}
    </tr>
  );
}
