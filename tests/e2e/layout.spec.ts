import { expect, open, test } from './support/page.ts';

const sizes = [
  { width: 1280, height: 720 },
  { width: 1440, height: 900 },
  { width: 820, height: 1180 },
  { width: 390, height: 844 },
];

for (const size of sizes)
  test(`${size.width}×${size.height}: both views and the clock on the first screen, nothing to scroll sideways`, async ({
    page,
  }) => {
    await page.setViewportSize(size);
    await open(page);
    for (const part of ['[data-view="local"]', '.play']) await expect(page.locator(part)).toBeInViewport({ ratio: 1 });
    await expect(page.locator('[data-view="global"]')).toBeInViewport({ ratio: 0.9 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(size.width);
  });

for (const size of sizes.slice(0, 2))
  test(`${size.width}×${size.height}: nothing of the equations lies under the clock`, async ({ page }) => {
    await page.setViewportSize(size);
    await open(page, './#/springs?scene="net"');
    const clock = await page.locator('.transport').boundingBox();
    for (const half of ['local', 'global']) {
      const last = await page.locator(`.half-${half} .in-code summary`).boundingBox();
      expect((last?.y ?? 0) + (last?.height ?? 0)).toBeLessThanOrEqual(clock?.y ?? 0);
    }
  });

test('on a projector the type is 18 px at least and the clock stays in sight', async ({ page }) => {
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page);
  await page.getByRole('button', { name: 'Projector' }).click();
  await expect(page.locator('.play')).toBeInViewport({ ratio: 1 });
  const smallest = await page.evaluate(() => {
    const visible = [...document.querySelectorAll('.springs-lab *')].filter(
      (element) =>
        [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim()) &&
        !element.closest('.katex, .visually-hidden, .below, .objective') && // subscripts are smaller by right
        (element as HTMLElement).offsetParent !== null,
    );
    return Math.min(...visible.map((element) => Number.parseFloat(getComputedStyle(element).fontSize)));
  });
  expect(smallest).toBeGreaterThanOrEqual(18);
});

test('nothing jumps while one walks through a time step', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.setViewportSize({ width: 1280, height: 720 });
  await open(page, './#/springs?scene="net"');
  const top = () => page.locator('.play').evaluate((element) => Math.round(element.getBoundingClientRect().top));
  const before = await top();
  for (const phase of ['local', 'global', 'local']) {
    await page.getByRole('button', { name: /^Half-step forward/ }).click();
    await expect(page.getByTestId('status')).toContainText(phase);
    expect(await top()).toBe(before);
  }
});
