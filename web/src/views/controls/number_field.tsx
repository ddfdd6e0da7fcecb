import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { parseNumber } from '../../lib/parse_number.ts';

interface Props {
  id: string;
  /** Null: none, an empty field. */
  value: number | null;
  min: number;
  max: number;
  whole?: boolean;
  unit: string;
  onSet: (value: number) => void;
  /** Where there need not be a number: what an empty field does. */
  onClear?: () => void;
  /** Stands behind the unit. */
  children?: ComponentChildren;
}

/** An exact value as text; what cannot be read or is out of range is answered with a sentence. */
export function NumberField({ id, value, min, max, whole = false, unit, onSet, onClear, children }: Props) {
  const [problem, setProblem] = useState<string | null>(null);
  /** What is being typed, however often the field is drawn meanwhile. */
  const [draft, setDraft] = useState<string | null>(null);
  useEffect(() => setProblem(null), [value]); // a slider or a reset has answered it

  const shown = value === null ? '' : showNumber(value);

  const read = (text: string) => {
    const number = parseNumber(text, unit);
    if (text.trim() === '' && onClear) {
      setProblem(null);
      onClear();
    } else if (number === null) setProblem(t('page.controls.notANumber', { text }));
    else if (number < min || number > max)
      setProblem(t('page.controls.outOfRange', { value: text, min: showNumber(min), max: showNumber(max) }));
    else if (whole && !Number.isInteger(number)) setProblem(t('page.controls.notWhole', { value: text }));
    else {
      setProblem(null);
      onSet(number);
    }
  };

  return (
    <>
      <span class="parameter-value">
        <input
          id={id}
          inputMode="decimal"
          autocomplete="off"
          value={draft ?? shown}
          aria-describedby={problem ? `${id}-problem` : undefined}
          onInput={({ currentTarget }) => setDraft(currentTarget.value)}
          onChange={({ currentTarget }) => {
            read(currentTarget.value);
            setDraft(null); // a refused text stays in the sentence only
          }}
          onKeyDown={(event) => {
            if (event.key === 'Enter') event.currentTarget.blur(); // and the page's own keys work again
          }}
        />
        <span class="unit">{unit}</span>
        {children}
      </span>
      {problem && (
        <p class="parameter-problem" id={`${id}-problem`} role="alert">
          {problem}
        </p>
      )}
    </>
  );
}

/** Short and exact enough to be typed again: 1/30 stays 0.03333 on screen only. */
export function showNumber(value: number): string {
  return value >= 1e6 ? value.toExponential().replace('e+', 'e') : String(Number(value.toPrecision(4)));
}
