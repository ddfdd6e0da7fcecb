import { type Catalogue, language } from './index.ts';

/** The texts in the language shown; reading them in a component renders it anew when the language changes. */
export function inLanguage<T>({ en, zh }: { en: T; zh: Catalogue<T> }): Catalogue<T> {
  return language.value === 'zh' ? zh : (en as Catalogue<T>);
}
