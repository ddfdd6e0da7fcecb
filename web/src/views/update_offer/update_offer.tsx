import { t } from '../../app/messages/index.ts';
import { applyUpdate, updateWaiting } from '../../app/updates.ts';
import './update_offer.css';

/** Offers the new version once it is here; nobody is moved to it in the middle of a lecture. */
export function UpdateOffer() {
  if (!updateWaiting.value) return null;
  return (
    <p class="update-offer" role="status">
      {t('page.update.ready')}{' '}
      <button type="button" onClick={applyUpdate}>
        {t('page.update.apply')}
      </button>
    </p>
  );
}
