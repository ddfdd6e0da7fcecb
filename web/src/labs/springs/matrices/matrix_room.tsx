import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { encodeLink } from '../../../app/link.ts';
import { matrices, matrixWishes, noWishes } from '../../../app/matrices.ts';
import { t } from '../../../app/messages/index.ts';
import { holds } from '../../../app/pointing.ts';
import { integratorsRoute } from '../../../app/route.ts';
import { labFigure, playing, state } from '../../../app/state.ts';
import type { SectionId } from '../../../notation/sections.ts';
import { Transport } from '../../../views/transport/transport.tsx';
import { AllMatrices } from './all_matrices.tsx';
import { EliminationStation } from './elimination_station.tsx';
import { ImplicitStation } from './implicit_station.tsx';
import { Ledger } from './ledger.tsx';
import './matrix_room.css';
import { NetPicture } from './net_picture.tsx';
import { roomWords } from './room_words.ts';
import { Storage } from './storage.tsx';
import { Tabs } from './tabs.tsx';
import { Terms } from './terms.tsx';

const stations = ['all', 'terms', 'elimination', 'ledger', 'storage', 'implicit'] as const;
type Station = (typeof stations)[number];

/** What the lesson says about it. */
const lessons: Record<Station, readonly SectionId[]> = {
  all: ['matrices'],
  terms: ['matrices', 'pins'],
  elimination: ['solving', 'sparse'],
  ledger: ['solving', 'pins'],
  storage: ['solving', 'sparse'],
  implicit: ['time', 'energy', 'matrices'],
};

/** While the page is open a reader who comes back finds the station that was left. */
const station = signal<Station>('all');

/** Beside the net, which is always in sight, one station after the other: each fits a projector's screen. */
export function MatrixRoom({ actions }: { actions: Actions }) {
  const words = roomWords();
  useEffect(() => {
    actions.pause(); // matrices are read, and b is, while the clock stands
    return () => {
      matrixWishes.value = noWishes;
    };
  }, [actions]);

  return (
    <main class="room matrix-room" ref={holds(labFigure)}>
      <h2 class="visually-hidden">{words.title}</h2>
      <NetPicture actions={actions} />
      <div class="matrix-stations">
        <Tabs
          label={words.stations.label}
          tabs={stations.map((id) => ({ id, name: words.stations[id] }))}
          chosen={station.value}
          onChoose={(id) => {
            matrixWishes.value = noWishes;
            station.value = id;
          }}
        >
          {station.value === 'ledger' ? <Ledger /> : <OfMatrices station={station.value} actions={actions} />}
          <Links station={station.value} />
        </Tabs>
      </div>
      <Transport actions={actions} />
    </main>
  );
}

/** To the lesson, and from the other integrators' matrix to their lab. */
function Links({ station: shown }: { station: Station }) {
  return (
    <p class="lesson-links">
      {roomWords().lesson}
      {lessons[shown].map((section) => (
        <a key={section} href={encodeLink({ page: 'lesson', section }, state.value)}>
          {t(`symbols.section.${section}`)}
        </a>
      ))}
      {shown === 'implicit' && (
        <a class="to-integrators" href={encodeLink(integratorsRoute, state.value)}>
          {roomWords().integrators}
        </a>
      )}
    </p>
  );
}

/** What needs the matrices themselves, once they are there. */
function OfMatrices({ station: shown, actions }: { station: Exclude<Station, 'ledger'>; actions: Actions }) {
  const words = roomWords();
  const read = matrices.value;
  if (!read) return <p class="matrix-waiting">{playing.value ? words.paused : words.waiting}</p>;
  switch (shown) {
    case 'all':
      return <AllMatrices matrices={read} actions={actions} />;
    case 'terms':
      return <Terms matrices={read} actions={actions} />;
    case 'elimination':
      return <EliminationStation matrices={read} actions={actions} />;
    case 'storage':
      return <Storage />;
    case 'implicit':
      return <ImplicitStation matrices={read} actions={actions} />;
  }
}
