import { gzipSync } from 'node:zlib';
import type { Response } from '@playwright/test';
import { expect, open, test } from './support/page.ts';

/** Sum over the responses of this content type, in bytes after gzip (a woff2 font is compressed already, gzip leaves it as it is). */
async function compressedSize(responses: Response[], contentType: RegExp): Promise<number> {
  const ofType = responses.filter((response) => contentType.test(response.headers()['content-type'] ?? ''));
  const bodies = await Promise.all(ofType.map((response) => response.body()));
  return bodies.reduce((sum, body) => sum + gzipSync(body).length, 0);
}

test('the first visit loads less than 400 kB of script and 150 kB of fonts', async ({ page }) => {
  const responses: Response[] = []; // of the page; what the service worker stores comes later, in the background
  page.on('response', (response) => responses.push(response));
  await open(page);
  await page.evaluate(() => document.fonts.ready);

  const script = await compressedSize(responses, /javascript/);
  expect(script).toBeGreaterThan(0);
  expect(script).toBeLessThan(400_000);
  expect(await compressedSize(responses, /^font\//)).toBeLessThan(150_000);
});
