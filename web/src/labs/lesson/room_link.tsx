import { encodeLink } from '../../app/link.ts';
import type { Room } from '../../app/route.ts';
import { state } from '../../app/state.ts';
import { lessonWords } from './lesson_words.ts';

/** From the small scenes of a section to the lab's own, in one of its rooms. */
export function RoomLink({ room }: { room: Extract<Room, 'matrices'> }) {
  return (
    <p>
      <a href={encodeLink({ page: 'springs', room }, state.value)}>{lessonWords().rooms[room]}</a>
    </p>
  );
}
