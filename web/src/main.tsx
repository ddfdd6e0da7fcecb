import { effect, signal } from '@preact/signals';
import { type ComponentType, render } from 'preact';
import { Actions } from './app/actions.ts';
import { followAddress, readAddress } from './app/address.ts';
import { preferredLanguage, t } from './app/messages/index.ts';
import { followPointing } from './app/pointing.ts';
import { appliedTheme } from './app/preferences.ts';
import { requireWebGL } from './app/require_webgl.ts';
import { roomKeys } from './app/room_keys.ts';
import { hasScenes, type Route, route } from './app/route.ts';
import { Session } from './app/session.ts';
import { shortcut } from './app/shortcuts.ts';
import { startLab } from './app/start_lab.ts';
import { newSolver } from './app/start_solver.ts';
import { state } from './app/state.ts';
import { keepOffline } from './app/updates.ts';
import { solving, work } from './app/work.ts';
import { cameraKey } from './labs/springs/camera_keys.ts';
import { symbolStyle } from './notation/symbol_style.ts';
import { Deferred } from './views/deferred/deferred.tsx';
import { Card } from './views/equations/cards/card.tsx';
import { formulaFonts } from './views/equations/formula_fonts.ts';
import { Header } from './views/header/header.tsx';
import { Help } from './views/help/help.tsx';
import { Notices } from './views/notices/notices.tsx';
import { Progress } from './views/progress/progress.tsx';
import { UpdateOffer } from './views/update_offer/update_offer.tsx';
import './style.css';

const helpOpen = signal(false);

effect(() => {
  document.documentElement.dataset.theme = appliedTheme.value;
  document.documentElement.toggleAttribute('data-projector', state.value.view.projector);
});
effect(() => {
  if (route.value.page === 'springs') document.title = t('page.title'); // the other pages name themselves
});

const symbolSheet = new CSSStyleSheet();
symbolSheet.replaceSync(symbolStyle());
document.adoptedStyleSheets.push(symbolSheet);

const client = newSolver((progress) => {
  solving.value = progress;
});
const session = new Session(client);
const actions = new Actions(session);

/** Each page with all it needs, once it is asked for. */
const pages: Record<Route['page'], () => Promise<ComponentType>> = {
  springs: async () => {
    const [{ SpringsLab }] = await Promise.all([import('./labs/springs/springs_lab.tsx'), startLab(client, actions)]);
    return () => <SpringsLab actions={actions} />;
  },
  integrators: async () => {
    requireWebGL();
    const { IntegratorsLab } = await import('./labs/integrators/integrators_lab.tsx');
    await formulaFonts(); // known since its style sheet has come
    return () => <IntegratorsLab actions={actions} />;
  },
  kinematics: async () => {
    requireWebGL();
    const { KinematicsLab } = await import('./labs/kinematics/kinematics_lab.tsx');
    await formulaFonts(); // known since its style sheet has come
    return () => <KinematicsLab actions={actions} />;
  },
  lesson: async () => {
    const { Lesson } = await import('./labs/lesson/lesson.tsx');
    return () => <Lesson actions={actions} />;
  },
};

function Page() {
  const { page } = route.value;
  return (
    <>
      <Header
        actions={actions}
        onHelp={() => {
          helpOpen.value = !helpOpen.value;
        }}
      />
      <Deferred key={page} load={pages[page]} />
      {helpOpen.value && (
        <Help
          onClose={() => {
            helpOpen.value = false;
          }}
        />
      )}
      <UpdateOffer />
      <Progress actions={actions} />
      <Notices />
      <Card />
    </>
  );
}

async function begin(): Promise<void> {
  actions.setLanguage(preferredLanguage(navigator.languages));
  await actions.follow(readAddress(location));
  session.start();
  followAddress((link) => actions.follow(link));
  listen();
  followPointing(document.documentElement);
  render(<Page />, document.getElementById('app') as HTMLElement);
  keepOffline();
}

/** What the whole page hears: keys that no control has taken, and files dropped on it. */
function listen(): void {
  addEventListener('keydown', (event) => {
    const { target } = event;
    if (event.key === 'Escape' && work.value) return actions.cancel();
    const typing = target instanceof Element && target.closest('input:not([type="file"]), select, textarea, summary');
    const pressing =
      target instanceof Element &&
      target.closest('button, a, input[type="file"]') &&
      (event.key === ' ' || event.key === 'Enter');
    if (
      typing ||
      pressing ||
      (event.repeat && !event.key.startsWith('Arrow')) ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey
    )
      return;
    if (event.key === '?') helpOpen.value = !helpOpen.value;
    else if (event.key === 'Escape') helpOpen.value = false;
    else if (roomKeys.value) {
      if (!roomKeys.value(event.key)) return;
    } else if (route.value.page !== 'springs') return;
    else if (!cameraKey(event.key, event.shiftKey) && !shortcut(event.key, actions)) return;
    event.preventDefault();
  });
  // A control used with the pointer gives the keys back to the page; one reached with the keyboard keeps them.
  for (const kind of ['click', 'change'])
    addEventListener(kind, ({ target }) => {
      const control =
        target instanceof Element && target.closest('button, select, input[type="checkbox"], input[type="range"]');
      if (control instanceof HTMLElement && !control.matches(':focus-visible')) {
        if (kind === 'change' || control.tagName !== 'SELECT') control.blur();
      }
    });
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', (event) => {
    event.preventDefault();
    if (hasScenes(route.value) && event.dataTransfer?.files.length)
      void actions.openFiles([...event.dataTransfer.files]);
  });
}

void begin();
