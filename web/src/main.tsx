import { effect, signal } from '@preact/signals';
import { render } from 'preact';
import { Actions } from './app/actions.ts';
import { followAddress, readAddress } from './app/address.ts';
import { language, t } from './app/messages/index.ts';
import { Obstacle } from './app/obstacle.ts';
import { followPointing } from './app/pointing.ts';
import { appliedTheme, reducedMotion } from './app/preferences.ts';
import { Session } from './app/session.ts';
import { shortcut } from './app/shortcuts.ts';
import { startSolver } from './app/start_solver.ts';
import { defaultState, state } from './app/state.ts';
import { keepOffline } from './app/updates.ts';
import { cameraKey } from './labs/springs/camera_keys.ts';
import { SpringsLab } from './labs/springs/springs_lab.tsx';
import { symbolStyle } from './notation/symbol_style.ts';
import { SymbolCard } from './views/equations/symbol_card.tsx';
import { Header } from './views/header/header.tsx';
import { Help } from './views/help/help.tsx';
import { Notices } from './views/notices/notices.tsx';
import { UpdateOffer } from './views/update_offer/update_offer.tsx';
import './style.css';

const helpOpen = signal(false);
const root = document.getElementById('app') as HTMLElement;

effect(() => {
  document.documentElement.dataset.theme = appliedTheme.value;
  document.documentElement.toggleAttribute('data-projector', state.value.view.projector);
});
effect(() => {
  document.title = t('page.title');
});

const symbolSheet = new CSSStyleSheet();
symbolSheet.replaceSync(symbolStyle());
document.adoptedStyleSheets.push(symbolSheet);

function Page({ actions }: { actions: Actions }) {
  return (
    <>
      <Header
        actions={actions}
        onHelp={() => {
          helpOpen.value = !helpOpen.value;
        }}
      />
      <SpringsLab actions={actions} />
      {helpOpen.value && (
        <Help
          onClose={() => {
            helpOpen.value = false;
          }}
        />
      )}
      <UpdateOffer />
      <Notices />
      <SymbolCard />
    </>
  );
}

async function begin(): Promise<void> {
  const asked = readAddress();
  language.value = asked.language;
  state.value = asked;
  render(<p class="obstacle">{t('page.loading')}</p>, root);

  const session = new Session(await startSolver());
  const actions = new Actions(session);
  const plain = { ...defaultState, language: asked.language, theme: asked.theme };
  const opened = (await actions.restore(asked)) || (await actions.restore(plain));
  if (!opened) throw new Obstacle('page.errors.noScene');
  session.start();
  render(<Page actions={actions} />, root);
  followAddress(() => actions.restore(readAddress()));
  listen(actions);
  followPointing(document.documentElement);
  keepOffline();
  if (!reducedMotion.value) actions.play();
}

/** What the whole page hears: keys that no control has taken, and files dropped on it. */
function listen(actions: Actions): void {
  addEventListener('keydown', (event) => {
    const { target } = event;
    const typing = target instanceof Element && target.closest('input, select, textarea, summary');
    const pressing =
      target instanceof Element && target.closest('button, a') && (event.key === ' ' || event.key === 'Enter');
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
    if (event.dataTransfer?.files.length) void actions.openFiles([...event.dataTransfer.files]);
  });
}

begin().catch((reason: unknown) => {
  const { key, params } =
    reason instanceof Obstacle ? reason : new Obstacle('page.errors.unexpected', { reason: String(reason) });
  effect(() =>
    render(
      <p class="obstacle" role="alert">
        {t(key, params)}
      </p>,
      root,
    ),
  );
});
