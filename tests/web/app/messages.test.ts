import { describe, expect, it } from 'vitest';
import { en } from '../../../web/src/app/messages/en/index.ts';
import { preferredLanguage } from '../../../web/src/app/messages/index.ts';
import { zh } from '../../../web/src/app/messages/zh/index.ts';

function flatten(texts: object, path = ''): [string, string][] {
  return Object.entries(texts).flatMap(([key, value]) =>
    typeof value === 'string' ? [[path + key, value] as [string, string]] : flatten(value, `${path}${key}.`),
  );
}

const english = flatten(en);
const chinese = new Map(flatten(zh));
const placeholders = (text: string) => [...text.matchAll(/\{\{(\w+)\}\}/g)].map(([, name]) => name).sort();

describe('the message catalogues', () => {
  it('have the same keys', () => {
    expect([...chinese.keys()].sort()).toEqual(english.map(([key]) => key).sort());
  });

  it('fill in the same values in both languages', () => {
    for (const [key, text] of english)
      expect(placeholders(chinese.get(key) as string), key).toEqual(placeholders(text));
  });

  it('have no empty text', () => {
    for (const [key, text] of [...english, ...chinese]) expect(text.trim(), key).not.toBe('');
  });
});

describe('preferredLanguage', () => {
  it.each([
    [['zh-CN', 'en'], 'zh'],
    [['de-DE', 'zh-Hant-TW', 'en'], 'zh'],
    [['en-GB', 'zh'], 'en'],
    [['fr'], 'en'],
    [[], 'en'],
  ] as const)('%j → %s', (preferred, language) => expect(preferredLanguage(preferred)).toBe(language));
});
