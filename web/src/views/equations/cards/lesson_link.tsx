import { t } from '../../../app/messages/index.ts';
import { pointAway } from '../../../app/pointing.ts';
import { type SectionId, sectionIds } from '../../../notation/sections.ts';

/** To where the lesson introduces it. */
export function LessonLink({ section }: { section: SectionId }) {
  return (
    <a href={`#/lesson/${section}`} onClick={pointAway}>
      {t('equations.card.lesson', {
        number: sectionIds.indexOf(section) + 1,
        title: t(`symbols.section.${section}`),
      })}
    </a>
  );
}
