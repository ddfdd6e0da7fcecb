import { Phrase } from '../../views/equations/prose.tsx';
import { lessonWords } from './lesson_words.ts';

/** Where it is written: at the end of every section. */
export function Sources({ items }: { items: Record<string, string> }) {
  const heading = lessonWords().sources;
  return (
    <section class="sources" aria-label={heading}>
      <h3>{heading}</h3>
      <ul>
        {Object.entries(items).map(([key, text]) => (
          <li key={key}>
            <Phrase text={text} />
          </li>
        ))}
      </ul>
    </section>
  );
}
