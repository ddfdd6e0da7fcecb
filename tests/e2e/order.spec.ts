import type { Page } from '@playwright/test';
import { en } from '../../web/src/labs/integrators/order/en.ts';
import { zh } from '../../web/src/labs/integrators/order/zh.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe, see support/axe.ts

const order = (page: Page) => page.locator('#order');

/** The experiment begins where it comes into sight. */
async function measured(page: Page, language: 'en' | 'zh' = 'en'): Promise<void> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, `#/integrators?language="${language}"`);
  await order(page).scrollIntoViewIfNeeded();
  await expect(order(page)).toHaveAttribute('data-measured', 'true', { timeout: 60_000 });
}

test('the slopes of all methods stand at the ends of their lines and in the table', async ({ page }) => {
  await measured(page);
  const ends = page.locator('#order text.curve');
  await expect(ends).toHaveText([/^slope 1\.0\d$/, /^slope 1\.0\d$/, /^slope (0\.9|1\.0)\d$/]);
  const rows = page.locator('.order-slopes tbody tr');
  await expect(rows).toHaveCount(5);
  for (const row of await rows.all()) await expect(row).toContainText(/(0\.9[5-9]|1\.0[0-5]).*µ?m?m$/);
  await expect(page.locator('#order .line-chart-names').first()).toContainText(
    'Linearly implicit Euler = Newton, converged = Local/global × 1',
  );
});

test('a spring that swings shows that one iteration of local/global gives another answer', async ({ page }) => {
  await measured(page);
  await page.getByRole('button', { name: en.cases.swing }).click();
  const rows = page.locator('.order-slopes tbody tr');
  await expect(rows).toHaveCount(6);
  await expect(rows.nth(2).locator('th')).toHaveText('Local/global × 1');
  await expect(rows.nth(2).locator('td')).toHaveText([/^0\.9\d$/, /^7\d\.\d.mm$/]);
  await expect(order(page)).toContainText('another answer');
});

test('the energy by each method is the predicted one, and the keys of the slider go beyond the limit', async ({
  page,
}) => {
  await measured(page);
  const slider = page.getByRole('slider', { name: en.energy.product });
  await expect(slider).toHaveAttribute('aria-valuetext', 'Δt·ω = 0.20');
  for (const method of ['forward-euler', 'symplectic-euler', 'newton']) {
    const cells = page.locator(`.order-energy [data-method="${method}"] td`);
    expect(await cells.first().innerText()).toBe(await cells.last().innerText());
  }
  await slider.press('End');
  await expect(slider).toHaveAttribute('aria-valuetext', 'Δt·ω = 2.20');
  await expect(page.locator('.order-verdict')).toContainText('explodes');
  await expect(page.locator('.order-energy [data-method="symplectic-euler"] td').last()).toHaveText(
    en.energy.unbounded,
  );
});

for (const language of ['en', 'zh'] as const)
  for (const viewport of [
    { width: 1280, height: 720 },
    { width: 390, height: 844 },
  ])
    test(`axe finds nothing serious, and nothing is too wide: ${language}, ${viewport.width} px`, async ({ page }) => {
      await page.setViewportSize(viewport);
      await measured(page, language);
      await page.getByRole('button', { name: { en, zh }[language].cases.swing }).click();
      await page.locator('#order summary').first().click(); // the numbers of the chart
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(viewport.width);
      expect(await seriousViolations(page)).toEqual([]);
    });
