import type { ComponentType } from 'preact';
import { useMemo } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { type Room, route } from '../../app/route.ts';
import { Deferred } from '../../views/deferred/deferred.tsx';
import { HalfSteps } from './half_steps.tsx';
import { RoomLinks } from './room_links.tsx';

/** One simulation, seen in several rooms; the first is the two half-steps side by side. */
export function SpringsLab({ actions }: { actions: Actions }) {
  const rooms = useMemo(() => roomsFor(actions), [actions]);
  const room = route.value.page === 'springs' ? route.value.room : null;
  return (
    <>
      <RoomLinks />
      {room === null ? <HalfSteps actions={actions} /> : <Deferred key={room} load={rooms[room]} />}
    </>
  );
}

/** Each with all it needs, once it is asked for. */
function roomsFor(actions: Actions): Record<Room, () => Promise<ComponentType>> {
  return {
    matrices: async () => {
      const { MatrixRoom } = await import('./matrices/matrix_room.tsx');
      return () => <MatrixRoom actions={actions} />;
    },
    convergence: async () => {
      const { ConvergenceRoom } = await import('./convergence/convergence_room.tsx');
      return () => <ConvergenceRoom actions={actions} />;
    },
    misconceptions: async () => {
      const { MisconceptionsRoom } = await import('./misconceptions/misconceptions_room.tsx');
      return () => <MisconceptionsRoom actions={actions} />;
    },
  };
}
