import { Prose } from '../../prose.tsx';
import { inLanguage } from '../../text.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

export function Optimisation() {
  const words = inLanguage({ en, zh });
  return <Prose text={words.intro} />;
}
