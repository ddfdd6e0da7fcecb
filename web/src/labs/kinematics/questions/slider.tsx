import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';
import { RangeInput } from '../../../lib/range_input.tsx';

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
      <RangeInput id={id} min={min} max={max} step={step} value={value} aria-valuetext={spoken} onValue={onSet} />
      <output for={id}>{text}</output>
    </div>
  );
}
