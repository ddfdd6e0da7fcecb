import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { notify } from '../../app/notices.ts';
import { route } from '../../app/route.ts';
import { sectionIds } from '../../notation/sections.ts';
import { Contents } from './contents.tsx';
import { LessonActions } from './lesson_actions.ts';
import { SectionFrame } from './section_frame.tsx';
import './lesson.css';
import './numbers.css';

/** The course's derivation, one section at a time: what it says can be touched. */
export function Lesson({ actions }: { actions: Actions }) {
  const asked = route.value.page === 'lesson' ? route.value.section : null;
  const known = sectionIds.find((id) => id === asked);
  const id = known ?? sectionIds[0];
  const title = t(`symbols.section.${id}`);
  const heading = useRef<HTMLHeadingElement>(null);
  const opened = useRef(id);

  useEffect(() => {
    if (known) return;
    if (asked !== null) notify('error', 'page.errors.linkPart', { part: '#', value: asked });
    route.value = { page: 'lesson', section: id };
  }, [known, asked, id]);

  useEffect(() => {
    document.title = `${title} – ${t('page.title')}`;
  }, [title]);

  useLayoutEffect(() => {
    if (opened.current === id) return;
    opened.current = id;
    scrollTo(0, 0);
    heading.current?.focus({ preventScroll: true }); // or the keyboard would go on from a link that is gone
  }, [id]);

  return (
    <LessonActions.Provider value={actions}>
      <div class="lesson">
        <Contents current={id} />
        <SectionFrame key={id} id={id} heading={heading} />
      </div>
    </LessonActions.Provider>
  );
}
