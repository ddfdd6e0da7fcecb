interface Props {
  min: number;
  max: number;
  value: number;
  onValue: (value: number) => void;
  id?: string;
  class?: string;
  step?: number;
  disabled?: boolean;
  title?: string;
  'aria-label'?: string;
  'aria-valuetext'?: string;
}

/** A slider whose track is filled up to where it stands; one without a choice stands at its beginning. */
export function RangeInput({ min, max, value, onValue, ...others }: Props) {
  const filled = max > min ? (value - min) / (max - min) : 0;
  return (
    <input
      {...others}
      type="range"
      min={min}
      max={max}
      value={value}
      style={{ '--filled': `${100 * filled}%` }}
      onInput={({ currentTarget }) => onValue(currentTarget.valueAsNumber)}
    />
  );
}
