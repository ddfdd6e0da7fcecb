import type { Locator } from '@playwright/test';
import { decode } from 'fast-png';

/** How many pixels of an element, as it is on the screen, have a colour that `is` says yes to. Channels 0 … 255. */
export async function countPixels(element: Locator, is: (r: number, g: number, b: number) => boolean): Promise<number> {
  const { data, channels } = decode(await element.screenshot());
  let count = 0;
  for (let at = 0; at < data.length; at += channels) {
    if (is(data[at], data[at + 1], data[at + 2])) count++;
  }
  return count;
}
