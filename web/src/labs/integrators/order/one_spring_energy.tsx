import { useId, useState } from 'preact/hooks';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatFixed, formatNumber } from '../../../lib/format.ts';
import { RangeInput } from '../../../lib/range_input.tsx';
import { type EnergyRatios, energyMethods, shownPeriods } from '../../../solver/energy_of_one_spring.ts';
import { LineChart } from '../../../views/charts/line_chart.tsx';
import { en } from './en.ts';
import { EnergyTable } from './energy_table.tsx';
import { firstPlace, products, stabilityLimit } from './products.ts';
import { zh } from './zh.ts';

/** What the energy becomes for a Δt·ω that the reader chooses, and what theory says it becomes. */
export function OneSpringEnergy({ energies }: { energies: readonly EnergyRatios[] }) {
  const words = inLanguage({ en, zh }).energy;
  const [place, setPlace] = useState(firstPlace);
  const slider = useId();
  const product = products[place];
  const last = products.length - 1;
  const limitPlace = products.indexOf(stabilityLimit) / last;
  const steps = (2 * Math.PI) / product;
  return (
    <>
      <div class="order-product" style={{ '--limit': limitPlace }}>
        <label for={slider}>{words.product}</label>
        <RangeInput
          id={slider}
          min={0}
          max={last}
          value={place}
          aria-valuetext={fillTemplate(words.productText, { product: formatFixed(product, 2) })}
          onValue={setPlace}
        />
        <output for={slider}>{formatFixed(product, 2)}</output>
        <span class="order-limit">{words.limit}</span>
      </div>
      <p class={product < stabilityLimit ? 'order-verdict' : 'order-verdict stability-beyond'}>
        {fillTemplate(product < stabilityLimit ? words.stable : words.unstable, { steps: formatNumber(steps) })}
      </p>
      <LineChart
        series={energyMethods.map((method) => ({
          name: words.methods[method],
          points: energies[place][method].map((ratio, step) => [step / steps, ratio] as const),
        }))}
        x={{ label: words.time, range: [0, shownPeriods] }}
        y={{ label: words.ratio, range: [0, 3] }}
        summary={words.summary}
      />
      <EnergyTable ratios={energies[place]} product={product} />
    </>
  );
}
