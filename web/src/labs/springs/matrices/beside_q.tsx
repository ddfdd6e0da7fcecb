import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { grouped } from '../../../lib/grouped.ts';
import type { LinearlyImplicitMatrices } from '../../../solver/matrices.ts';
import type { Triplets } from '../../../solver/module.ts';
import { Prose } from '../../../views/equations/prose.tsx';
import { roomWords } from './room_words.ts';

/** How many numbers either matrix holds, and how often it is factorised. */
export function BesideQ({ read, Q }: { read: LinearlyImplicitMatrices; Q: Triplets }) {
  const words = roomWords().implicit.compare;
  const [q, system] = [Q.value.length, read.system.value.length];
  return (
    <section class="beside-q" data-testid="beside-q">
      <h3>{words.title}</h3>
      <Prose
        text={fillTemplate(words.text, {
          q: grouped(q),
          system: grouped(system),
          ratio: formatNumber(system / q, 1),
          free: grouped(read.constrained.value.length),
        })}
      />
    </section>
  );
}
