import { t } from '../../app/messages/index.ts';
import { dismiss, notices, reading } from '../../app/notices.ts';
import { Icon } from '../../lib/icon.tsx';
import './notices.css';

function hold(on: boolean): void {
  reading.value = on;
}

/** Sentences about what just happened, in a corner; never in the way, read out as they come. */
export function Notices() {
  return (
    <div
      class="notices"
      aria-live="polite"
      role="status"
      onMouseEnter={() => hold(true)}
      onMouseLeave={() => hold(false)}
      onFocusIn={() => hold(true)}
      onFocusOut={() => hold(false)}
    >
      {notices.value.map(({ id, kind, key, params }) => (
        <p key={id} class={`notice notice-${kind}`}>
          <span>{t(key, params)}</span>
          <button type="button" class="quiet" aria-label={t('page.notice.dismiss')} onClick={() => dismiss(id)}>
            <Icon name="close" />
          </button>
        </p>
      ))}
    </div>
  );
}
