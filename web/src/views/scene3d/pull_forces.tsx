import { effect, type ReadonlySignal } from '@preact/signals';
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { formatForce } from '../../lib/format.ts';
import type { Pull } from '../../solver/protocol.ts';
import type { Nets3D } from './nets3d.ts';

/** CSS pixels from the handle to the top of its label, above it or, where there is no room, below. */
const roomAbove = 46;
const below = 22;

interface ForceProps {
  nets: Nets3D;
  net: number;
  /** Changes with every picture. */
  pictures: ReadonlySignal<number>;
}

/** The force that pulls at one net, N, beside the handle. */
export function PullForce({ nets, net, pictures }: ForceProps) {
  const label = useRef<HTMLSpanElement>(null);

  // Without rendering it anew with every picture.
  useLayoutEffect(
    () =>
      effect(() => {
        void pictures.value;
        const pull = nets.shownPulls()[net];
        if (!label.current) return;
        label.current.hidden = !pull;
        if (!pull) return;
        label.current.textContent = formatForce(pull.force);
        label.current.style.setProperty('--x', `${pull.x}px`);
        const aside = pull.y < roomAbove ? below : -roomAbove;
        label.current.style.setProperty('--y', `${pull.y + aside}px`);
      }),
    [nets, net, pictures],
  );
  return <span ref={label} class="net-force" aria-hidden="true" hidden />;
}

/** ms without a change of the pull after which its forces are read out: they come to something only then. */
const settling_ms = 500;

/** What is pulled, and by how much in each net, for those who hear it. */
export function PullReport({ nets, pull }: { nets: Nets3D; pull: Pull | null }) {
  const [said, say] = useState('');
  useEffect(() => {
    if (!pull) return say((before) => (before ? t('page.poke.letGo') : ''));
    const later = setTimeout(() => {
      const forces = nets.shownPulls().map((shown) => (shown ? formatForce(shown.force) : ''));
      const [vertex] = pull.vertices;
      const more = pull.vertices.length - 1;
      say(t(more > 0 ? 'page.poke.several' : 'page.poke.one', { vertex, more, forces: forces.join(', ') }));
    }, settling_ms);
    return () => clearTimeout(later);
  }, [nets, pull]);
  return (
    <p class="visually-hidden" aria-live="polite">
      {said}
    </p>
  );
}
