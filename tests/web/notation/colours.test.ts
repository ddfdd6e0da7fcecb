import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { symbol, symbolIds } from '../../../web/src/notation/symbols.ts';

type Colour = readonly [number, number, number];
type Matrix = readonly [Colour, Colour, Colour];

const css = ['notation/colours.css', 'style.css']
  .map((path) => readFileSync(new URL(`../../../web/src/${path}`, import.meta.url), 'utf8'))
  .join('\n');

/** Custom properties with a colour value that the theme's block sets, as linear RGB in 0 … 1. */
function palette(selector: string): Map<string, Colour> {
  const blocks = css.split('}').filter((block) => block.split('{')[0].trim().endsWith(selector));
  const declarations = blocks.join('\n').matchAll(/(--[\w-]+): (#[0-9a-f]{6})/gi);
  return new Map([...declarations].map(([, name, hex]) => [name, linear(hex)]));
}

function linear(hex: string): Colour {
  const channel = (at: number) => {
    const c = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  };
  return [channel(1), channel(3), channel(5)];
}

const dot = (a: Colour, b: Colour) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const apply = (m: Matrix, c: Colour): Colour => [dot(m[0], c), dot(m[1], c), dot(m[2], c)];
const clamp = (c: Colour) => c.map((x) => Math.min(1, Math.max(0, x))) as unknown as Colour;

/** WCAG 2. */
function contrast(a: Colour, b: Colour): number {
  const [light, dark] = [a, b].map((c) => dot(c, [0.2126, 0.7152, 0.0722])).sort((x, y) => y - x);
  return (light + 0.05) / (dark + 0.05);
}

/** Full dichromacy after Machado, Oliveira and Fernandes (2009), on linear RGB. */
const visions: Record<string, Matrix> = {
  'normal vision': [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ],
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
};

/** Oklab (Ottosson 2020), in which equal distances look about equally large. */
function oklab(c: Colour): Colour {
  const lms = apply(
    [
      [0.4122214708, 0.5363325363, 0.0514459929],
      [0.2119034982, 0.6806995451, 0.1073969566],
      [0.0883024619, 0.2817188376, 0.6299787005],
    ],
    c,
  ).map(Math.cbrt) as unknown as Colour;
  return apply(
    [
      [0.2104542553, 0.793617785, -0.0040720468],
      [1.9779984951, -2.428592205, 0.4505937099],
      [0.0259040371, 0.7827717662, -0.808675766],
    ],
    lms,
  );
}

const tokens = [...new Set(symbolIds.map((id) => symbol(id).colour))];
const meeting = tokens.filter((token) => token !== '--symbol-other');

describe.each([
  ['light', ':root'],
  ['dark', '[data-theme="dark"]'],
])('the %s palette', (_, selector) => {
  const colours = palette(selector);
  const colour = (name: string) => colours.get(name) as Colour;

  it.each(tokens)('%s is readable on everything that text stands on', (token) => {
    for (const background of ['--background', '--surface', '--accent-soft']) {
      expect(contrast(colour(token), colour(background)), background).toBeGreaterThanOrEqual(4.5); // WCAG AA
    }
  });

  it.each(Object.entries(visions))('tells the symbols of the two equations apart: %s', (_, vision) => {
    const seen = meeting.map((token) => oklab(clamp(apply(vision, colour(token)))));
    for (const [i, a] of seen.entries()) {
      for (const [j, b] of seen.entries()) {
        if (j >= i) continue;
        // 0.02 is about what an eye just notices in patches; small letters need several times that
        expect(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), `${meeting[i]} ${meeting[j]}`).toBeGreaterThan(0.1);
      }
    }
  });
});
