import type { Actions } from '../../../app/actions.ts';
import { t } from '../../../app/messages/index.ts';
import { Transport } from '../../../views/transport/transport.tsx';

export function MisconceptionsRoom({ actions }: { actions: Actions }) {
  return (
    <main class="room misconceptions-room">
      <h2>{t('page.rooms.misconceptions')}</h2>
      <Transport actions={actions} />
    </main>
  );
}
