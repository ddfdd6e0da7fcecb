import { useEffect, useRef } from 'preact/hooks';
import { type MessageKey, t } from '../../app/messages/index.ts';
import { type Route, route } from '../../app/route.ts';
import { Icon } from '../../lib/icon.tsx';
import './help.css';

interface Topics {
  gestures: readonly MessageKey[];
  keys: readonly (readonly [key: string, meaning: MessageKey])[];
}

/** What can be done on each page. */
const topics: Record<Route['page'], Topics> = {
  springs: {
    gestures: ['page.keys.drag', 'page.keys.click', 'page.keys.shiftClick', 'page.keys.orbit'],
    keys: [
      ['Space', 'page.keys.space'],
      ['A', 'page.keys.animate'],
      ['← →', 'page.keys.halfSteps'],
      ['↑ ↓', 'page.keys.steps'],
      ['L', 'page.keys.springs'],
      ['W', 'page.keys.wind'],
      ['R', 'page.keys.reset'],
      ['Shift ← → ↑ ↓', 'page.keys.turn'],
      ['+  −  0', 'page.keys.zoom'],
      ['?', 'page.keys.help'],
      ['Esc', 'page.keys.escape'],
      ['← → ↑ ↓', 'page.keys.pinArrows'],
      ['PgUp PgDn', 'page.keys.pinPages'],
    ],
  },
  integrators: {
    gestures: ['page.keys.integrators.pull', 'page.keys.drag', 'page.keys.orbit'],
    keys: [
      ['Space', 'page.keys.space'],
      ['A', 'page.keys.animate'],
      ['R', 'page.keys.integrators.restart'],
      ['I', 'page.keys.integrators.instant'],
      ['Enter ← → ↑ ↓', 'page.keys.integrators.hold'],
      ['?', 'page.keys.help'],
      ['Esc', 'page.keys.escape'],
      ['← → ↑ ↓', 'page.keys.pinArrows'],
      ['PgUp PgDn', 'page.keys.pinPages'],
    ],
  },
  kinematics: {
    gestures: ['page.keys.kinematics.target', 'page.keys.orbit'],
    keys: [
      ['A', 'page.keys.kinematics.play'],
      ['← →', 'page.keys.kinematics.events'],
      ['R', 'page.keys.kinematics.hang'],
      ['← → ↑ ↓', 'page.keys.kinematics.targetArrows'],
      ['?', 'page.keys.help'],
      ['Esc', 'page.keys.escape'],
    ],
  },
  lesson: {
    gestures: ['page.keys.drag', 'page.keys.lesson.pull', 'page.keys.lesson.choose', 'page.keys.lesson.symbol'],
    keys: [
      ['Tab', 'page.keys.lesson.tab'],
      ['Enter', 'page.keys.lesson.open'],
      ['← →', 'page.keys.lesson.rove'],
      ['← → ↑ ↓', 'page.keys.lesson.pinArrows'],
      ['← →', 'page.keys.lesson.slider'],
      ['?', 'page.keys.help'],
      ['Esc', 'page.keys.lesson.escape'],
    ],
  },
};

/** The list of keys and gestures, beside the page rather than over it: nothing stops while it is open. */
export function Help({ onClose }: { onClose: () => void }) {
  const close = useRef<HTMLButtonElement>(null);
  const { gestures, keys } = topics[route.value.page];
  useEffect(() => {
    const before = document.activeElement;
    close.current?.focus();
    return () => {
      if (before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <aside
      class="help"
      aria-labelledby="help-heading"
      onKeyDown={(event) => {
        if (event.key === 'Escape') onClose();
      }}
    >
      <div class="help-title">
        <h2 id="help-heading">{t('page.header.help')}</h2>
        <button ref={close} type="button" class="quiet" aria-label={t('page.keys.close')} onClick={onClose}>
          <Icon name="close" />
        </button>
      </div>
      <h3>{t('page.keys.pointer')}</h3>
      <ul>
        {gestures.map((text) => (
          <li key={text}>{t(text)}</li>
        ))}
      </ul>
      <h3>{t('page.keys.keyboard')}</h3>
      <dl>
        {keys.map(([key, text]) => (
          <div key={text}>
            <dt>
              <kbd>{key}</kbd>
            </dt>
            <dd>{t(text)}</dd>
          </div>
        ))}
      </dl>
    </aside>
  );
}
