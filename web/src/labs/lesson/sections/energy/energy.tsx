import { inLanguage } from '../../../../app/messages/in_language.ts';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import { InSlices } from '../../in_slices.tsx';
import { Sources } from '../../sources.tsx';
import { ClosestVector } from './closest_vector.tsx';
import { en } from './en.ts';
import { EnergySlice } from './energy_slice.tsx';
import { ForceCheck } from './force_check.tsx';
import { zh } from './zh.ts';
import './energy.css';

export function Energy() {
  const words = inLanguage({ en, zh });
  return (
    <InSlices>
      <Prose text={words.intro} />
      <h3>{words.force.title}</h3>
      <Prose text={words.force.text} />
      <h3>{words.closest.title}</h3>
      <Prose text={words.closest.text} />
      <ClosestVector words={words.closest} />
      <Prose text={words.collapsed} />
      <Question ask={words.quadratic.ask} hint={words.quadratic.hint} answer={words.quadratic.answer}>
        <EnergySlice words={words.quadratic} caption={words.quadratic.caption} />
      </Question>
      <Question ask={words.sign.ask} hint={words.sign.hint} answer={words.sign.answer}>
        <ForceCheck words={words.sign} />
      </Question>
      <Sources items={words.sources} />
    </InSlices>
  );
}
