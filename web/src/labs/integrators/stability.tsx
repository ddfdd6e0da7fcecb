import type { MethodChoice } from '../../app/integrators.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { fillTemplate } from '../../lib/fill_template.ts';
import { formatNumber } from '../../lib/format.ts';
import type { Method, Parameters } from '../../solver/module.ts';
import { Phrase } from '../../views/equations/prose.tsx';
import { en } from './en.ts';
import { stabilityLimits, substepsBelow } from './stability_limits.ts';
import { zh } from './zh.ts';

interface Props {
  /** rad/s: of the fastest oscillation. */
  omega: number;
  parameters: Pick<Parameters, 'delta_t' | 'damping' | 'k'>;
  methods: readonly MethodChoice[];
}

/** On which side of the explicit methods' limits the chosen numbers are; alarming only for whoever has chosen one beyond its limit. */
export function Stability({ omega, parameters: { delta_t, damping, k }, methods }: Props) {
  const words = inLanguage({ en, zh }).stability;
  const product = omega * delta_t;
  const limits = stabilityLimits(omega, damping, k);
  const sentences = [
    ['symplectic-euler', words.symplectic, limits.symplectic],
    ['forward-euler', words.forward, limits.forward],
  ] as const;
  const explodes = (method: Method, limit: number) =>
    methods.some((choice) => choice.method === method && product >= limit * choice.substeps);
  return (
    <div class="stability">
      <p>
        <Phrase text={fillTemplate(words.omega, { omega: formatNumber(omega), product: formatNumber(product) })} />
      </p>
      {sentences.map(([method, sentence, limit]) => (
        <p key={method} class={explodes(method, limit) ? 'stability-beyond' : undefined}>
          {fillTemplate(limit === 0 ? words.never : product < limit ? sentence.holds : sentence.explodes, {
            limit: formatNumber(limit),
            substeps: substepsBelow(limit, product),
          })}
        </p>
      ))}
      <p>{words.implicit}</p>
    </div>
  );
}
