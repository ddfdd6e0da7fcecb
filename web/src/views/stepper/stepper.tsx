import { inLanguage } from '../../app/messages/in_language.ts';
import { RangeInput } from '../../lib/range_input.tsx';
import { en } from './en.ts';
import { zh } from './zh.ts';
import './stepper.css';
import { StepButton } from './step_button.tsx';

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
  const words = inLanguage({ en, zh });
  return (
    <fieldset class="stepper" aria-label={label}>
      <StepButton icon="reset" label={words.first} off={step === 0} onClick={() => onStep(0)} />
      <StepButton icon="previousStep" label={words.back} off={step === 0} onClick={() => onStep(step - 1)} />
      <StepButton icon="nextStep" label={words.forward} off={step === last} onClick={() => onStep(step + 1)} />
      <RangeInput min={0} max={last} value={step} aria-label={label} onValue={onStep} />
      <output class="stepper-place">
        {step} / {last}
      </output>
    </fieldset>
  );
}
