import { explicitMethods, type MethodChoice } from '../../app/integrators.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatNumber } from '../../lib/format.ts';
import { Phrase } from '../../views/equations/prose.tsx';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** Of Δt·ω: symplectic Euler explodes beyond. */
const limit = 2;

interface Props {
  /** rad/s: of the fastest oscillation. */
  omega: number;
  /** s. */
  delta_t: number;
  methods: readonly MethodChoice[];
}

/** On which side of the explicit methods' limit the chosen numbers are. */
export function Stability({ omega, delta_t, methods }: Props) {
  const words = inLanguage({ en, zh }).stability;
  const product = omega * delta_t;
  const stable = product < limit;
  const explodes = methods.some(
    ({ method, substeps }) => explicitMethods.includes(method) && product >= limit * substeps,
  );
  return (
    <div>
      <p class="stability">
        <Phrase text={fillTemplate(words.omega, { omega: formatNumber(omega), product: formatNumber(product) })} />
      </p>
      <p class={explodes ? 'stability stability-beyond' : 'stability'}>
        {stable ? words.stable : fillTemplate(words.unstable, { substeps: Math.floor(product / limit) + 1 })}
      </p>
    </div>
  );
}
