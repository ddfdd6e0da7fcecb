import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { work } from '../../app/work.ts';
import './progress.css';

/** What the reader waits for, how far it is, and the way out. */
export function Progress({ actions }: { actions: Actions }) {
  const now = work.value;
  if (!now) return null;
  const share = now.fraction > 0 ? now.fraction : undefined; // without a value the bar moves, and measures nothing
  return (
    <div class="progress">
      <label>
        <span role="status">{t(`page.progress.${now.stage}`, { ...now })}</span>
        {share !== undefined && (
          <span class="progress-share" aria-hidden="true">
            {Math.floor(100 * share)} %
          </span>
        )}
        <progress value={share} />
      </label>
      <button type="button" onClick={() => actions.cancel()}>
        {t('page.progress.cancel')} <kbd>Esc</kbd>
      </button>
    </div>
  );
}
