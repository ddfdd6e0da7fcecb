import { signal } from '@preact/signals';
import { createInstance, type TOptions } from 'i18next';
import type { SceneMessages } from '../../scene/scene_error.ts';
import { en } from './en/index.ts';
import { zh } from './zh/index.ts';

export const languages = ['en', 'zh'] as const;
export type Language = (typeof languages)[number];

/** The catalogue's shape with every text a plain string: `zh` has to satisfy it, so a missing key fails the build. */
export type Catalogue<T> = { [K in keyof T]: T[K] extends string ? string : Catalogue<T[K]> };

type Path<T> = { [K in keyof T & string]: T[K] extends string ? Singular<K> : `${K}.${Path<T[K]>}` }[keyof T & string];
/** i18next picks key_one or key_other by `count`: callers name the key alone. */
type Singular<K extends string> = K extends `${infer Stem}_${'one' | 'other'}` ? Stem : K;
export type MessageKey = Path<typeof en>;

const instance = createInstance();
void instance.init({
  lng: 'en',
  fallbackLng: false,
  initAsync: false,
  resources: { en: { translation: en }, zh: { translation: zh } },
  interpolation: { escapeValue: false }, // texts are rendered as text nodes, never as HTML
});

const current = signal<Language>('en');

/** The language shown. Reading it (or calling `t`) inside a component re-renders the component when it changes. */
export const language = {
  get value(): Language {
    return current.value;
  },
  set value(next: Language) {
    void instance.changeLanguage(next);
    document.documentElement.lang = next === 'zh' ? 'zh-Hans' : 'en';
    current.value = next;
  },
};

/** Texts without parameters, once looked up: panels show a hundred with every frame, and i18next takes longer for one than its element does. */
const constants: Record<Language, Map<MessageKey, string>> = { en: new Map(), zh: new Map() };

/** The text for `key` in the language shown, `{{name}}` filled in from `params`. */
export function t(key: MessageKey, params?: TOptions): string {
  const lng = current.value;
  if (params) return instance.t(key, { ...params, lng });
  const text = constants[lng].get(key) ?? instance.t(key, { lng });
  constants[lng].set(key, text);
  return text;
}

/** The sentences of scene errors in the language shown, for describeSceneError. */
export function sceneMessages(): SceneMessages {
  return current.value === 'zh' ? zh.scene : en.scene;
}

/** The first of the reader's preferred languages that we speak. */
export function preferredLanguage(preferred: readonly string[]): Language {
  for (const tag of preferred) {
    if (tag.toLowerCase().startsWith('zh')) return 'zh';
    if (tag.toLowerCase().startsWith('en')) return 'en';
  }
  return 'en';
}
