import { gzipSync } from 'node:zlib';
import type { Response } from '@playwright/test';
import { expect, open, test } from './support/page.ts';

/** One line a file of this content type: bytes after gzip (which leaves a woff2 font about as it is), address. */
async function compressedSizes(responses: Response[], contentType: RegExp): Promise<[bytes: number, url: string][]> {
  const ofType = responses.filter((response) => contentType.test(response.headers()['content-type'] ?? ''));
  return Promise.all(ofType.map(async (response) => [gzipSync(await response.body()).length, response.url()]));
}

function expectWithin(budget: number, sizes: [bytes: number, url: string][]) {
  const total = sizes.reduce((sum, [bytes]) => sum + bytes, 0);
  expect(total).toBeGreaterThan(0);
  expect(total, sizes.map((size) => size.join(' ')).join('\n')).toBeLessThan(budget);
}

test('the first visit loads less than 400 kB of script and 150 kB of fonts', async ({ page }) => {
  const responses: Response[] = []; // of the page; what the service worker stores comes later, in the background
  page.on('response', (response) => responses.push(response));
  await open(page);
  await page.evaluate(() => document.fonts.ready.then(() => undefined));
  expectWithin(400_000, await compressedSizes(responses, /javascript/));
  expectWithin(150_000, await compressedSizes(responses, /^font\//));
});
