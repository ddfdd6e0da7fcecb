import { useEffect, useRef } from 'preact/hooks';
import { encodeLink } from '../../app/link.ts';
import { t } from '../../app/messages/index.ts';
import { type Room, rooms, route } from '../../app/route.ts';
import { state } from '../../app/state.ts';
import './room_links.css';

const all: readonly (Room | null)[] = [null, ...rooms];

/** From room to room; scene, parameters, pins and moment come along. */
export function RoomLinks() {
  const here = route.value.page === 'springs' ? route.value.room : null;
  const nav = useRef<HTMLElement>(null);
  useEffect(() => {
    const current = nav.current?.querySelector('[aria-current]');
    if (here) current?.scrollIntoView({ block: 'nearest', inline: 'nearest' }); // on a narrow phone
  }, [here]);
  return (
    <nav ref={nav} class="room-links" aria-label={t('page.rooms.label')}>
      {all.map((room) => (
        <a
          key={room}
          href={encodeLink({ page: 'springs', room }, state.value)}
          aria-current={room === here ? 'page' : undefined}
        >
          {t(`page.rooms.${room ?? 'halfSteps'}`)}
        </a>
      ))}
    </nav>
  );
}
