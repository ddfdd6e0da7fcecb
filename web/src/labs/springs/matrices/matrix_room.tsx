import type { Actions } from '../../../app/actions.ts';
import { t } from '../../../app/messages/index.ts';
import { Transport } from '../../../views/transport/transport.tsx';

export function MatrixRoom({ actions }: { actions: Actions }) {
  return (
    <main class="room matrix-room">
      <h2>{t('page.rooms.matrices')}</h2>
      <Transport actions={actions} />
    </main>
  );
}
