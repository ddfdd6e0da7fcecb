import { formatQuantity } from '../../lib/format.ts';

export interface Part {
  name: string;
  ms: number;
  /** A custom property of the page. */
  colour: string;
}

interface Props {
  name: string;
  parts: readonly Part[];
  budget_ms: number;
  /** Whose budget it is, e.g. "60 Hz". */
  budgetName: string;
}

/** What something takes of the time there is for it: a bar, and the same in words. */
export function TimeBudget({ name, parts, budget_ms, budgetName }: Props) {
  const total = parts.reduce((sum, { ms }) => sum + ms, 0);
  const whole = Math.max(total, budget_ms);
  const percent = (ms: number) => `${(100 * ms) / whole}%`;
  const words = `${milliseconds(total)} / ${milliseconds(budget_ms)} (${budgetName})`;
  return (
    <div class="budget">
      <p class="budget-name">
        <span>{name}</span> <span>{words}</span>
      </p>
      <div class="budget-bar" aria-hidden="true">
        {parts.map(({ name: part, ms, colour }) => (
          <span key={part} style={{ width: percent(ms), background: `var(${colour})` }} />
        ))}
        {total > budget_ms && <b style={{ left: percent(budget_ms) }} />}
      </div>
      {parts.length > 1 && <PartList parts={parts} />}
    </div>
  );
}

export function PartList({ parts }: Pick<Props, 'parts'>) {
  return (
    <ul>
      {parts.map(({ name, ms, colour }) => (
        <li key={name}>
          <i style={{ background: `var(${colour})` }} /> {name} <span>{milliseconds(ms)}</span>
        </li>
      ))}
    </ul>
  );
}

function milliseconds(ms: number): string {
  return formatQuantity(ms, 'ms', 2);
}
