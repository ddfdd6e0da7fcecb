import { t } from '../../../app/messages/index.ts';
import { pointAway } from '../../../app/pointing.ts';
import { type SectionId, sectionIds } from '../../../notation/sections.ts';

/** To where the lesson introduces it, if it does. */
export function LessonLink({ section }: { section: SectionId | null }) {
  if (section === null) return null;
  return (
    <a href={`#/lesson/${section}`} onClick={pointAway}>
      {t('equations.card.lesson', {
        number: sectionIds.indexOf(section) + 1,
        title: t(`symbols.section.${section}`),
      })}
    </a>
  );
}
