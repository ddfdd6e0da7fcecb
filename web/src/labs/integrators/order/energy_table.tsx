import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { formatNumber } from '../../../lib/format.ts';
import { type EnergyRatios, energyMethods } from '../../../solver/energy_of_one_spring.ts';
import { en } from './en.ts';
import { type EnergyLaw, measuredLaw, perPeriod, predictedLaw } from './energy_laws.ts';
import { Swatch } from './swatch.tsx';
import { zh } from './zh.ts';

/** Significant digits: enough to see that measured and predicted are the same number. */
const digits = 4;

/** What every method does to the energy in a time step and in a period: measured beside predicted. */
export function EnergyTable({ ratios, product }: { ratios: EnergyRatios; product: number }) {
  const words = inLanguage({ en, zh }).energy;
  return (
    <table class="results order-energy">
      <caption>{words.caption}</caption>
      <thead>
        <tr>
          <th scope="col">{words.method}</th>
          <th scope="col">{words.measured}</th>
          <th scope="col">{words.predicted}</th>
        </tr>
      </thead>
      <tbody>
        {energyMethods.map((method, at) => (
          <tr key={method} data-method={method}>
            <th scope="row">
              <Swatch curve={at} />
              {words.methods[method]}
            </th>
            <td>
              <Law law={measuredLaw(method, ratios[method])} product={product} />
            </td>
            <td>
              <Law law={predictedLaw(method, product)} product={product} />
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Law({ law, product }: { law: EnergyLaw; product: number }) {
  const words = inLanguage({ en, zh }).energy;
  if (law.kind === 'factor')
    return (
      <>
        {fillTemplate(words.aStep, { factor: formatNumber(law.factor, digits) })}
        <br />
        {fillTemplate(words.aPeriod, { factor: formatNumber(perPeriod(law.factor, product), digits) })}
      </>
    );
  if (law.most === Number.POSITIVE_INFINITY) return <>{words.unbounded}</>;
  return <>{fillTemplate(words.band, { least: formatNumber(law.least), most: formatNumber(law.most) })}</>;
}
