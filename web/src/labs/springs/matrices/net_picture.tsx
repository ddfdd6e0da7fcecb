import { useComputed } from '@preact/signals';
import type { Actions } from '../../../app/actions.ts';
import { litThings } from '../../../app/highlight.ts';
import { labFigure, pins, scene, state } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { Stage } from '../stage.tsx';
import { roomWords } from './room_words.ts';

/** The net, in which lights up what is pointed at in a matrix; and the other way round. */
export function NetPicture({ actions }: { actions: Actions }) {
  const { label } = roomWords().net;
  return (
    <section class="net-picture" aria-label={label}>
      <Stage actions={actions} label={label} />
      <div class="net-picture-view" data-view="global" />
      <Meant />
    </section>
  );
}

/** The spring and vertex that are pointed at, or else selected. */
function Meant() {
  const meant = useComputed(() => {
    const lit = litThings(labFigure);
    return lit.spring === null && lit.vertex === null ? state.value.selection : lit;
  });
  const words = roomWords().net;
  const { spring, vertex } = meant.value;
  const { E } = scene.value;
  return (
    <p class="net-meant" data-testid="meant">
      {spring !== null && (
        <span>{fillTemplate(words.spring, { e: spring, i: E[2 * spring], j: E[2 * spring + 1] })}</span>
      )}
      {vertex !== null && (
        <span>{fillTemplate(pins.value.pinned.includes(vertex) ? words.pin : words.vertex, { v: vertex })}</span>
      )}
      {spring === null && vertex === null && <span>{words.nothing}</span>}
    </p>
  );
}
