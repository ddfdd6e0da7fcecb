import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';

interface Props {
  label: ComponentChildren;
  value: number;
  min: number;
  max: number;
  step: number;
  /** The value with its unit. */
  text: string;
  /** How it is heard, where that is more. */
  spoken?: string;
  onSet: (value: number) => void;
}

/** One number of an experiment. */
export function Slider({ label, value, min, max, step, text, spoken = text, onSet }: Props) {
  const id = useId();
  return (
    <div class="question-slider">
      <label for={id}>{label}</label>
      <input
        id={id}
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        style={{ '--filled': `${(100 * (value - min)) / (max - min)}%` }}
        aria-valuetext={spoken}
        onInput={(event) => onSet(event.currentTarget.valueAsNumber)}
      />
      <output for={id}>{text}</output>
    </div>
  );
}
