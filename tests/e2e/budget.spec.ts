import { gzipSync } from 'node:zlib';
import type { Page, Response } from '@playwright/test';
import { expect, open, test } from './support/page.ts';

/** Of every file of this content type: bytes after gzip (which leaves a woff2 font about as it is), address. */
async function compressedSizes(
  page: Page,
  responses: Response[],
  contentType: RegExp,
): Promise<[bytes: number, url: string][]> {
  const ofType = responses.filter((response) => contentType.test(response.headers()['content-type'] ?? ''));
  return Promise.all(
    ofType.map(async (response) => {
      // Fetched again: the bodies of what a worker loaded go when it ends.
      const body = await (await page.request.get(response.url())).body();
      return [gzipSync(body).length, response.url()];
    }),
  );
}

function expectWithin(budget: number, sizes: [bytes: number, url: string][]) {
  const total = sizes.reduce((sum, [bytes]) => sum + bytes, 0);
  expect(total).toBeGreaterThan(0);
  expect(total, sizes.map((size) => size.join(' ')).join('\n')).toBeLessThan(budget);
}

for (const [first, address] of [
  ['lab', './'],
  ['lesson', './#/lesson/trick'],
])
  test(`the first visit loads less than 400 kB of script and 150 kB of fonts: ${first}`, async ({ page }) => {
    const responses: Response[] = []; // of the page; what the service worker stores comes later, in the background
    page.on('response', (response) => responses.push(response));
    await open(page, address);
    await page.evaluate(() => document.fonts.ready.then(() => undefined));
    expectWithin(400_000, await compressedSizes(page, responses, /javascript/));
    expectWithin(150_000, await compressedSizes(page, responses, /^font\//));
  });
