import { lessonWords } from '../lesson_words.ts';
import { TransportButton } from './transport_button.tsx';

interface Props {
  /** What is stepped through. */
  label: string;
  /** 0 … last. */
  step: number;
  last: number;
  onStep: (step: number) => void;
}

/** Forwards and backwards through something that needs no solver. */
export function Stepper({ label, step, last, onStep }: Props) {
  const words = lessonWords().stepper;
  return (
    <fieldset class="figure-transport" aria-label={label}>
      <TransportButton icon="reset" label={words.first} off={step === 0} onClick={() => onStep(0)} />
      <TransportButton icon="previousStep" label={words.back} off={step === 0} onClick={() => onStep(step - 1)} />
      <TransportButton icon="nextStep" label={words.forward} off={step === last} onClick={() => onStep(step + 1)} />
      <input
        type="range"
        min={0}
        max={last}
        value={step}
        style={{ '--filled': `${(100 * step) / Math.max(1, last)}%` }}
        aria-label={label}
        onInput={(event) => onStep(event.currentTarget.valueAsNumber)}
      />
      <output class="figure-place">
        {step} / {last}
      </output>
    </fieldset>
  );
}
