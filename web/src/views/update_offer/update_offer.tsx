import { registerSW } from 'virtual:pwa-register';
import { signal } from '@preact/signals';
import { t } from '../../app/messages/index.ts';
import './update_offer.css';

const waiting = signal(false);
const update = registerSW({
  onNeedRefresh: () => {
    waiting.value = true;
  },
});

/** Offers the new version once it is here; nobody is moved to it in the middle of a lecture. */
export function UpdateOffer() {
  if (!waiting.value) return null;
  return (
    <p class="update-offer" role="status">
      {t('page.update.ready')}{' '}
      <button type="button" onClick={() => void update(true)}>
        {t('page.update.apply')}
      </button>
    </p>
  );
}
