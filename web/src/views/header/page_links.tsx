import { encodeLink } from '../../app/link.ts';
import { t } from '../../app/messages/index.ts';
import { integratorsRoute, kinematicsRoute, type Route, route, springsRoute } from '../../app/route.ts';
import { state } from '../../app/state.ts';

const destinations: readonly Route[] = [
  springsRoute,
  integratorsRoute,
  kinematicsRoute,
  { page: 'lesson', section: null },
];

/** From page to page. A lab's link carries its state, so that coming back finds it as it was left. */
export function PageLinks() {
  return (
    <nav class="page-links" aria-label={t('page.header.pages.label')}>
      {destinations.map((to) => (
        <a
          key={to.page}
          href={encodeLink(to, state.value)}
          aria-current={to.page === route.value.page ? 'page' : undefined}
        >
          {t(`page.header.pages.${to.page}`)}
        </a>
      ))}
    </nav>
  );
}
