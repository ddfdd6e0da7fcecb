import { expectReady, open, test } from './support/page.ts';

test('after one visit the app starts without a network', async ({ page, context }) => {
  await open(page);
  // Active means installed: everything is in the cache.
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
  await context.setOffline(true);
  await page.reload();
  await expectReady(page);
});
