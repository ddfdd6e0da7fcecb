import type { Actions } from '../../../app/actions.ts';
import { t } from '../../../app/messages/index.ts';
import { Transport } from '../../../views/transport/transport.tsx';

export function ConvergenceRoom({ actions }: { actions: Actions }) {
  return (
    <main class="room convergence-room">
      <h2>{t('page.rooms.convergence')}</h2>
      <Transport actions={actions} />
    </main>
  );
}
