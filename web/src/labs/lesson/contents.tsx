import { t } from '../../app/messages/index.ts';
import { pathOf } from '../../app/route.ts';
import { type SectionId, sectionIds } from '../../notation/sections.ts';
import { lessonWords } from './lesson_words.ts';

/** Links to all sections: beside the text where there is room, else folded above it. */
export function Contents({ current }: { current: SectionId }) {
  const words = lessonWords();
  return (
    <nav class="contents" aria-label={words.contents}>
      <details open={matchMedia('(min-width: 1000px)').matches}>
        <summary>{words.contents}</summary>
        <ol>
          {sectionIds.map((id) => (
            <li key={id}>
              <a href={pathOf({ page: 'lesson', section: id })} aria-current={id === current ? 'page' : undefined}>
                {t(`symbols.section.${id}`)}
              </a>
            </li>
          ))}
        </ol>
      </details>
    </nav>
  );
}
