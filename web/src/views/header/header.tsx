import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { hasScenes, route } from '../../app/route.ts';
import { state } from '../../app/state.ts';
import { PageLinks } from './page_links.tsx';
import { SceneMenu } from './scene_menu.tsx';
import './header.css';

const themes = ['system', 'light', 'dark'] as const;

/** Name of the page, and what concerns all of it: language, theme, size of type, the link, the keys. */
export function Header({ actions, onHelp }: { actions: Actions; onHelp: () => void }) {
  const { language, theme, view } = state.value;
  const other = language === 'en' ? 'zh' : 'en';
  const inLab = route.value.page !== 'lesson';
  return (
    <header class="header">
      <button
        type="button"
        class="skip"
        onClick={() => document.getElementById(inLab ? 'transport' : 'lesson-text')?.focus()}
      >
        {t(inLab ? 'page.skip' : 'page.skipToText')}
      </button>
      <h1>
        <svg viewBox="0 0 32 20" width="32" height="20" aria-hidden="true">
          <path
            d="M2 10h4l2-6 4 12 4-12 4 12 2-6h4"
            fill="none"
            stroke="var(--accent)"
            stroke-width="2"
            stroke-linejoin="round"
            stroke-linecap="round"
          />
          <circle cx="29" cy="10" r="2.5" fill="var(--accent)" />
        </svg>
        {t('page.title')}
      </h1>
      <PageLinks />
      {hasScenes(route.value) && <SceneMenu actions={actions} />}
      <div class="tools">
        <label class="theme">
          <span class="visually-hidden">{t('page.header.theme.label')}</span>
          <select value={theme} onChange={(event) => actions.setTheme(event.currentTarget.value as typeof theme)}>
            {themes.map((name) => (
              <option key={name} value={name}>
                {t(`page.header.theme.${name}`)}
              </option>
            ))}
          </select>
        </label>
        <button
          type="button"
          class="wide-only"
          aria-pressed={view.projector}
          title={t('page.header.projectorHint')}
          onClick={() => actions.setView({ projector: !view.projector })}
        >
          {t('page.header.projector')}
        </button>
        <button type="button" onClick={() => actions.copyLink()}>
          {t('page.header.link')}
        </button>
        <button
          type="button"
          lang={other === 'zh' ? 'zh-Hans' : 'en'}
          aria-label={t('page.header.otherLanguageLabel')}
          onClick={() => actions.setLanguage(other)}
        >
          {t('page.header.otherLanguage')}
        </button>
        <button type="button" aria-label={t('page.header.help')} title={t('page.header.help')} onClick={onHelp}>
          ?
        </button>
      </div>
    </header>
  );
}
