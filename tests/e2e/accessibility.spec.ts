import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';

for (const language of ['en', 'zh'])
  for (const theme of ['light', 'dark'])
    for (const viewport of [
      { width: 1280, height: 720 },
      { width: 390, height: 844 },
    ])
      test(`axe finds nothing serious: ${language}, ${theme}, ${viewport.width}×${viewport.height}`, async ({
        browser,
        baseURL,
      }) => {
        const context = await browser.newContext({
          bypassCSP: true,
          viewport,
          reducedMotion: 'reduce',
          baseURL: baseURL as string,
        });
        const page = await context.newPage();
        await open(page, `./#/springs?scene="net"&language="${language}"&theme="${theme}"`);
        await page.keyboard.press('Space');
        expect(await seriousViolations(page)).toEqual([]);
        await page.locator('.objective figcaption button').last().click();
        await expect(page.locator('.comparison-readout')).toBeVisible();
        expect(await seriousViolations(page)).toEqual([]);
        await context.close();
      });

test('nothing is wider than a phone', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  const width = () => page.evaluate(() => document.documentElement.scrollWidth);
  expect(await width()).toBeLessThanOrEqual(390);
  await page.getByRole('button', { name: 'Methods', exact: true }).click();
  await expect(page.locator('.comparison-readout')).toBeVisible();
  expect(await width()).toBeLessThanOrEqual(390);
});

test('the whole page can be reached with the keyboard alone', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page);
  const reached = new Set<string>();
  for (let press = 0; press < 150; press++) {
    await page.keyboard.press('Tab');
    const name = await page.evaluate(() => {
      const element = document.activeElement;
      return (
        element?.getAttribute('aria-label') ?? element?.closest('label')?.textContent ?? element?.textContent ?? ''
      );
    });
    reached.add(name.trim());
    if (reached.has('Wind')) break; // past the transport and the equations, into the controls
  }
  for (const name of ['Half-step back', 'One time step', 'Reset to rest', 'Wind']) expect([...reached]).toContain(name);
  for (const beginning of ['Half-step forward', 'Pin 1 of 6'])
    expect([...reached].some((name) => name.startsWith(beginning))).toBe(true);
});
