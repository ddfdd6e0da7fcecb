import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { pathOf } from '../../app/route.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { type SectionId, sectionIds } from '../../notation/sections.ts';
import { Deferred } from '../../views/deferred/deferred.tsx';
import { lessonWords } from './lesson_words.ts';
import { sections } from './sections/index.ts';

interface Props {
  id: SectionId;
  heading: RefObject<HTMLHeadingElement | null>;
}

/** What every section has: number, title, and the ways to its neighbours. */
export function SectionFrame({ id, heading }: Props) {
  const words = lessonWords();
  const index = sectionIds.indexOf(id);
  const title = t(`symbols.section.${id}`);
  useEffect(() => {
    document.body.dataset.ready = 'true';
  }, []);
  return (
    <main class="section" id="lesson-text" tabIndex={-1}>
      <p class="section-number">{fillTemplate(words.section, { number: index + 1 })}</p>
      <h2 ref={heading} tabIndex={-1}>
        {title}
      </h2>
      <Deferred load={sections[id]} />
      <nav class="section-neighbours" aria-label={words.neighbours}>
        <Neighbour id={sectionIds[index - 1]} label={words.previous} />
        <Neighbour id={sectionIds[index + 1]} label={words.next} />
      </nav>
    </main>
  );
}

function Neighbour({ id, label }: { id: SectionId | undefined; label: string }) {
  if (!id) return <span />;
  return (
    <a href={pathOf({ page: 'lesson', section: id })}>
      <span>{label}</span> {t(`symbols.section.${id}`)}
    </a>
  );
}
