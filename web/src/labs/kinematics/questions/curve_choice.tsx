import { Choice } from '../../../lib/choice.tsx';
import { questionWords } from './question_words.ts';

interface Props<Curve extends string> {
  curves: readonly Curve[];
  chosen: Curve;
  onChoose: (curve: Curve) => void;
}

/** Along which curve an experiment runs. */
export function CurveChoice<Curve extends 'both' | 'circle' | 'heart' | 'drawn'>({
  curves,
  chosen,
  onChoose,
}: Props<Curve>) {
  const words = questionWords().curves;
  return (
    <Choice
      label={words.label}
      options={curves.map((curve) => [curve, words[curve]] as const)}
      chosen={chosen}
      onChoose={onChoose}
    />
  );
}
