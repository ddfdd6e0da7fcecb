import { formatLength } from '../../../lib/format.ts';
import { questionWords } from './question_words.ts';
import type { ReachByMethod } from './use_reach.ts';

/** For every method: its iterations with the question for the distance and without, how near it came without, and what the next frame does. */
export function UnreachableTable({ results }: { results: readonly ReachByMethod[] }) {
  const { unreachable: words, methods } = questionWords();
  return (
    <table class="question-table">
      <caption>{words.caption}</caption>
      <thead>
        <tr>
          <td />
          <th scope="colgroup">{words.tested}</th>
          <th scope="colgroup" colSpan={3}>
            {words.untested}
          </th>
        </tr>
        <tr>
          <th scope="col">{words.method}</th>
          <th scope="col">{words.iterations}</th>
          <th scope="col" class="group">
            {words.iterations}
          </th>
          <th scope="col">{words.left}</th>
          <th scope="col">{words.creeps}</th>
        </tr>
      </thead>
      <tbody>
        {results.map(({ method, tested, untested, beyond, creeps }) => (
          <tr key={method} data-method={method}>
            <th scope="row">{methods[method]}</th>
            <td>{tested.iterations}</td>
            <td class="group">{untested.iterations}</td>
            <td>{formatLength(beyond[beyond.length - 1] ?? 0, 2)}</td>
            <td>{formatLength(creeps, 2)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
