import { expect, open, test } from './support/page.ts';

test.beforeEach(async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, './#/springs?scene="net"');
  await page.getByRole('button', { name: /^Half-step forward/ }).click();
  await expect(page.getByTestId('status')).toContainText('local');
});

test('a symbol under the pointer shows its card, and is marked wherever it stands', async ({ page }) => {
  await page.locator('.half-global .equation-formulas [data-sym="d"]').first().hover();
  const card = page.locator('.card');
  await expect(card).toContainText('#E × 3');
  await expect(page.locator('.half-local .equation-formulas [data-sym="d"]').first()).toHaveCSS('box-shadow', /2px/);
  await page.mouse.move(5, 5);
  await expect(card).toHaveCount(0);
});

test('a symbol’s button opens its card for the keyboard, Escape closes it', async ({ page }) => {
  await page.locator('.half-global .symbol-legend button').first().focus();
  await expect(page.locator('.card')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.locator('.card')).toHaveCount(0);
});

test('the numbers of the local step are those of its equation: d has the rest length', async ({ page }) => {
  const facts = await page.locator('.half-local .equation-facts').first().textContent();
  const r = Number(facts?.match(/r = ([\d.]+)/)?.[1]);
  const lengths = page.locator('.half-local .vector-table tr:last-child td:last-child');
  expect(Number(await lengths.textContent())).toBe(r);
});
